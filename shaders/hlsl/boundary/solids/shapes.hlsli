// The shapes of solids: how far a point is from one's surface, which way is out, and how much of the kernel around the
// point lies in it. A box is exact. Round ones have the share of a ball of the same mean curvature: a cylinder's side that
// of one of twice its radius. A share of a box or of a cylinder's ends is a product of shares along axes, as walls' are
// (boundary/walls.hlsli). Errors: test `shares_of_shapes_are_close_to_their_integrals` of the twin. Includers declare
// `solid_fields`.
#ifndef BROOKLET_SHAPES
#define BROOKLET_SHAPES

#include "../../shared/layout.hlsli"
#include "layout.hlsli"
#include "beyond_plane.hlsli"
#include "field.hlsli"

struct Surface
{
    float distance_m;       // negative inside
    float3 normal;          // of length 1, away from it
};

struct ShapeShare
{
    float share;            // of the kernel that lies in the shape
    float3 slope;           // of that over the position, 1/h
};

// Of a direction that may be none.
float3 Direction(float3 v, float3 otherwise)
{
    float length_squared = dot(v, v);
    return length_squared > 1.0e-24 ? v * rsqrt(length_squared) : otherwise;
}

Surface SurfaceOfBox(float3 from_middle_m, float3 half_m)
{
    float3 side = float3(from_middle_m.x < 0.0 ? -1.0 : 1.0, from_middle_m.y < 0.0 ? -1.0 : 1.0,
                         from_middle_m.z < 0.0 ? -1.0 : 1.0);
    float3 beyond_m = abs(from_middle_m) - half_m;
    float3 outside_m = max(beyond_m, 0.0);
    float furthest_m = max(beyond_m.x, max(beyond_m.y, beyond_m.z));
    float3 face = beyond_m.x >= furthest_m ? float3(1.0, 0.0, 0.0)
                : beyond_m.y >= furthest_m ? float3(0.0, 1.0, 0.0) : float3(0.0, 0.0, 1.0);
    Surface surface;
    surface.distance_m = length(outside_m) + min(furthest_m, 0.0);
    surface.normal = side * Direction(outside_m, face);
    return surface;
}

Surface SurfaceOfCapsule(float3 from_middle_m, float3 half_m)
{
    float3 from_axis_m = from_middle_m;
    from_axis_m.y -= clamp(from_middle_m.y, -half_m.y, half_m.y);
    Surface surface;
    surface.distance_m = length(from_axis_m) - half_m.x;
    surface.normal = Direction(from_axis_m, float3(1.0, 0.0, 0.0));
    return surface;
}

Surface SurfaceOfCylinder(float3 from_middle_m, float3 half_m)
{
    float radius_m = length(from_middle_m.xz);
    float2 radial = radius_m > 1.0e-12 ? from_middle_m.xz / radius_m : float2(1.0, 0.0);
    float along = from_middle_m.y < 0.0 ? -1.0 : 1.0;
    float2 beyond_m = float2(radius_m - half_m.x, abs(from_middle_m.y) - half_m.y);
    float2 outside_m = max(beyond_m, 0.0);
    float furthest_m = max(beyond_m.x, beyond_m.y);
    float outside_length_m = length(outside_m);
    float2 out_m = outside_length_m > 1.0e-12 ? outside_m / outside_length_m
                 : beyond_m.x >= beyond_m.y ? float2(1.0, 0.0) : float2(0.0, 1.0);
    Surface surface;
    surface.distance_m = outside_length_m + min(furthest_m, 0.0);
    surface.normal = float3(radial.x * out_m.x, along * out_m.y, radial.y * out_m.x);
    return surface;
}

Surface SurfaceOfShape(uint shape, float3 from_middle_m, float3 half_m)
{
    if (shape == SHAPE_BOX)
        return SurfaceOfBox(from_middle_m, half_m);
    if (shape == SHAPE_CAPSULE)
        return SurfaceOfCapsule(from_middle_m, half_m);
    return SurfaceOfCylinder(from_middle_m, half_m);
}

// Outside of the grid all of the mesh is at least as far away as from the nearest place in it, and beyond that.
Surface SurfaceOfField(Solid solid, float3 place_m)
{
    FieldSample field = SampleField(solid, place_m);
    float3 normal = Direction(field.distance_slope, float3(0.0, 1.0, 0.0));
    Surface surface;
    surface.distance_m = field.value.x;
    surface.normal = normal;
    if (any(field.outside_m != 0.0))
    {
        float3 away_m = max(field.value.x, 0.0) * normal + field.outside_m;
        surface.distance_m = length(float2(max(field.value.x, 0.0), length(field.outside_m)));
        surface.normal = Direction(away_m, normal);
    }
    return surface;
}

// At a place in the solid's frame. Of a hollow one the nearer of its outside and of its cavity, which are cut out of each
// other: nowhere more than the distance, but of a field.
Surface SurfaceOf(Solid solid, float3 place_m)
{
    if (solid.shape == SHAPE_FIELD)
        return SurfaceOfField(solid, place_m);
    Surface surface;
    surface.distance_m = -1.0e30;
    surface.normal = 0.0;
    // A loop over outside and cavity, so that the shapes' code is there once: it is what a driver builds longest.
    [loop]
    for (uint part = 0; part <= solid.is_hollow; ++part)
    {
        bool outside = part == 0;
        float3 middle_m = outside ? 0.0 : 0.5 * (solid.cavity_min_m + solid.cavity_max_m);
        float3 half_m = outside ? solid.half_m : 0.5 * (solid.cavity_max_m - solid.cavity_min_m);
        float side = outside ? 1.0 : -1.0;
        Surface of = SurfaceOfShape(solid.shape, place_m - middle_m, half_m);
        if (side * of.distance_m > surface.distance_m)
        {
            surface.distance_m = side * of.distance_m;
            surface.normal = side * of.normal;
        }
    }
    return surface;
}

// Of the kernel between two planes along each axis, and its slopes.
void BetweenPlanes(float3 low, float3 high, SmoothingKernelParams kernel, out float3 share, out float3 slope)
{
    [unroll]
    for (uint axis = 0; axis < 3; ++axis)
    {
        float2 below = BeyondPlane(low[axis], kernel);
        float2 above = BeyondPlane(high[axis], kernel);
        share[axis] = max(1.0 - below.x - above.x, 0.0);
        slope[axis] = below.y - above.y;
    }
}

// Of the kernel in a ball of a radius in h, of half an h or more, at a signed distance from its surface: the plane's, less
// what the surface curves away. With D the distance to its middle, the integral over the kernel's shells is
//   (R F(s) -+ G(s)) / D,  G(s) = 21/2 times the integral over q > s of (1-q)^4 (1+4q) q (q-s)^2,
// which is t^7 (1/2 - 9/16 t + 1/6 t^2) in t = 1 - s.
float2 BeyondBall(float distance, float radius, SmoothingKernelParams kernel)
{
    float2 plane = BeyondPlane(abs(distance), kernel);
    float reach = saturate(1.0 - abs(distance));
    float reach2 = reach * reach;
    float reach6 = reach2 * reach2 * reach2;
    float curved = reach6 * reach * (0.5 + reach * (-0.5625 + reach / 6.0));
    float curved_slope = reach6 * (3.5 + reach * (-4.5 + reach * 1.5));
    float to_middle = max(radius + distance, 0.5 * radius);
    float side = distance < 0.0 ? -1.0 : 1.0;
    float share = (radius * plane.x - side * curved) / to_middle;
    float slope = (radius * plane.y - side * curved_slope) / to_middle + side * share / to_middle;
    return float2(distance < 0.0 ? 1.0 - share : share, slope);
}

ShapeShare ShareOfBox(float3 place, float3 low, float3 high, SmoothingKernelParams kernel)
{
    float3 share, slope;
    BetweenPlanes(place - low, high - place, kernel, share, slope);
    ShapeShare of;
    of.share = share.x * share.y * share.z;
    of.slope = slope * share.yzx * share.zxy;
    return of;
}

ShapeShare ShareOfCapsule(float3 from_middle, float3 half, SmoothingKernelParams kernel)
{
    float3 from_axis = from_middle;
    from_axis.y -= clamp(from_middle.y, -half.y, half.y);
    float from_axis_length = length(from_axis);
    // Beside an end the surface is a ball's, elsewhere a cylinder's.
    float ends = BeyondPlane(half.y - from_middle.y, kernel).x + BeyondPlane(half.y + from_middle.y, kernel).x;
    float2 ball = BeyondBall(from_axis_length - half.x, half.x / (0.5 + 0.5 * ends), kernel);
    ShapeShare of;
    of.share = ball.x;
    of.slope = -ball.y * Direction(from_axis, 0.0);
    return of;
}

// Of a cylinder between two heights.
ShapeShare ShareOfCylinder(float3 place, float radius, float low, float high, SmoothingKernelParams kernel)
{
    float from_axis = length(place.xz);
    float2 side = BeyondBall(from_axis - radius, 2.0 * radius, kernel);
    float2 below = BeyondPlane(place.y - low, kernel);
    float2 above = BeyondPlane(high - place.y, kernel);
    float between = max(1.0 - below.x - above.x, 0.0);
    float2 radial = from_axis > 1.0e-6 ? place.xz / from_axis : 0.0;
    ShapeShare of;
    of.share = side.x * between;
    of.slope = float3(-side.y * between * radial.x, side.x * (below.y - above.y), -side.y * between * radial.y);
    return of;
}

ShapeShare ShareOfShape(uint shape, float3 place, float3 low, float3 high, SmoothingKernelParams kernel)
{
    if (shape == SHAPE_BOX)
        return ShareOfBox(place, low, high, kernel);
    if (shape == SHAPE_CAPSULE)
        return ShareOfCapsule(place - 0.5 * (low + high), 0.5 * (high - low), kernel);
    return ShareOfCylinder(place, 0.5 * (high.x - low.x), low.y, high.y, kernel);
}

ShapeShare ShareOfField(Solid solid, float3 place_m, SmoothingKernelParams kernel)
{
    FieldSample field = SampleField(solid, place_m);
    float2 beyond = BeyondPlane(field.value.y, kernel);
    bool outside = any(field.outside_m != 0.0);
    ShapeShare of;
    of.share = outside ? 0.0 : beyond.x;
    of.slope = outside ? 0.0 : -beyond.y * kernel.support_m * field.plane_slope;
    return of;
}

// At a place in the solid's frame. Of a hollow one the shape's without the cavity's, which is cut off where it is open.
ShapeShare ShareOf(Solid solid, float3 place_m, SmoothingKernelParams kernel)
{
    if (solid.shape == SHAPE_FIELD)
        return ShareOfField(solid, place_m, kernel);
    float per_m = kernel.inverse_support_per_m;
    float3 high = solid.half_m * per_m;
    ShapeShare of;
    of.share = 0.0;
    of.slope = 0.0;
    [loop]
    for (uint part = 0; part <= solid.is_hollow; ++part)
    {
        bool outside = part == 0;
        float3 low_end = outside ? -high : max(solid.cavity_min_m * per_m, -high);
        float3 high_end = outside ? high : min(solid.cavity_max_m * per_m, high);
        float side = outside ? 1.0 : -1.0;
        ShapeShare more = ShareOfShape(solid.shape, place_m * per_m, low_end, high_end, kernel);
        of.share = max(of.share + side * more.share, 0.0);
        of.slope += side * more.slope;
    }
    return of;
}

#endif
