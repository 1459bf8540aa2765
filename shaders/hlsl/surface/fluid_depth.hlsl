// The nearest of all particles' spheres, or ellipsoids (surface/anisotropy.compute), in each pixel, as
// inverse_depth. At the walls they are cut off: there the water is as flat as the wall.
#pragma vertex FluidDepthVertex
#pragma fragment FluidDepthFragment
#pragma multi_compile _ SPRAY_SHAPE ELLIPSOID_SHAPE

#include "../shared/layout.hlsli"
#include "layout.hlsli"
#include "impostor.hlsli"
#include "spray.hlsli"

#if defined(ELLIPSOID_SHAPE)
StructuredBuffer<Ellipsoid> ellipsoids;
#else
StructuredBuffer<Position> positions;
#endif
#if defined(SPRAY_SHAPE)
StructuredBuffer<ListHead> list_heads;
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<SurfaceParams> surface;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
    [[vk::location(1)]] float3 ray : TEXCOORD1;
    // Distance of the middle, tan^2 of the half angle it is seen under, and radius.
    [[vk::location(2)]] nointerpolation float3 shape : TEXCOORD2;
};

Varyings FluidDepthVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    float2 corner = DiscCorner(vertex);
#if defined(ELLIPSOID_SHAPE)
    Impostor impostor = ImpostorOfEllipsoid(view, ellipsoids[instance], surface.radius_m, corner);
    const float radius_m = 1.0; // as the impostor's distance: in radii
#else
    Position particle = positions[instance];
    float radius_m = surface.radius_m;
#if defined(SPRAY_SHAPE)
    radius_m *= SizeOf(list_heads[instance]);
#endif
    Impostor impostor = ImpostorOf(view, particle.position_m, particle.tag, radius_m, corner);
#endif
    Varyings output;
    // The triangle stands at the sphere's nearest point, so the depth written is never nearer
    // than its own: hidden spheres can be rejected early (SV_DepthLessEqual).
    output.position = ClipFromOffset(view, impostor.ray * (impostor.distance_m - radius_m));
    output.disc = corner;
    output.ray = impostor.ray;
    output.shape = float3(impostor.distance_m, impostor.tan2, radius_m);
    if (!impostor.drawn)
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // every corner in one point: nothing is drawn
    return output;
}

struct Surface
{
    float inverse_depth_per_m : SV_Target0;
    float depth : SV_DepthLessEqual;
};

Surface FluidDepthFragment(Varyings input)
{
    float s = dot(input.disc, input.disc);
    if (s > 1.0)
        discard;
    // Ray against sphere with the outline at |disc| = 1: the discriminant is r^2 (1 - s) / (1 + s tan^2),
    // free of the cancellation that D^2 - r^2 would bring far away.
    float distance_m = input.shape.x;
    float half_chord_m = input.shape.z * sqrt(1.0 - s);
    float scale = 1.0 / (1.0 + s * input.shape.y);
    float enter = (distance_m - half_chord_m) * scale;
    float leave = (distance_m + half_chord_m) * scale;
    // The box's slabs (Kay & Kajiya 1986). A ray along a slab has an infinite inverse, which works out.
    float3 inverse = 1.0 / input.ray;
    float3 a = (surface.wall_min_m - view.eye_m) * inverse;
    float3 b = (surface.wall_max_m - view.eye_m) * inverse;
    float3 near3 = min(a, b);
    float3 far3 = max(a, b);
    float along = max(enter, max(near3.x, max(near3.y, near3.z)));
    if (along > min(leave, min(far3.x, min(far3.y, far3.z))))
        discard;
    Surface output;
    output.inverse_depth_per_m = 1.0 / (along * dot(input.ray, view.forward));
    output.depth = view.near_m * output.inverse_depth_per_m;
    return output;
}
