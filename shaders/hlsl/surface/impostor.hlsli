// A particle's sphere on a camera-facing triangle, in perspective.
#ifndef BROOKLET_IMPOSTOR
#define BROOKLET_IMPOSTOR

#include "../shared/tag.hlsli"
#include "../frame/camera.hlsli"
#include "ellipsoid.hlsli"

struct Impostor
{
    float3 ray;         // through the corner; length 1 along the line from the eye to the middle
    float distance_m;   // of the middle
    float tan2;         // tan^2 of the half angle that it is seen under
    bool drawn;         // not quarantined, and the eye is outside of it
};

Impostor ImpostorOf(FrameView view, float3 center_m, uint tag, float radius_m, float2 corner)
{
    float3 center = center_m - view.eye_m;
    float distance_m = length(center);
    float3 axis = center / distance_m;
    // Any two directions across the axis do; the camera's own keep the corners screen-aligned.
    float3 across = normalize(cross(axis, view.up));
    float3 upward = cross(across, axis);
    float radius2 = radius_m * radius_m;
    Impostor impostor;
    impostor.distance_m = distance_m;
    impostor.tan2 = radius2 / (distance_m * distance_m - radius2);
    impostor.ray = axis + sqrt(impostor.tan2) * (corner.x * across + corner.y * upward);
    impostor.drawn = IsSimulated(tag) && distance_m > radius_m;
    return impostor;
}

// `corner` in two directions across a unit axis that may point anywhere (Duff et al. 2017).
float3 AcrossAxis(float3 axis, float2 corner)
{
    float side = axis.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (side + axis.z);
    float b = axis.x * axis.y * a;
    float3 across = float3(1.0 + side * axis.x * axis.x * a, side * b, -side * axis.x);
    float3 upward = float3(b, side + axis.y * axis.y * a, -axis.y);
    return corner.x * across + corner.y * upward;
}

// An ellipsoid's, as that of the unit sphere in the space that its matrix stretches from: a linear
// map takes the tangent cone to the tangent cone, so the triangle is as tight, and lengths along a
// ray, in units of it, stay. `distance_m` is then in radii.
Impostor ImpostorOfEllipsoid(FrameView view, Ellipsoid ellipsoid, float radius_m, float2 corner)
{
    float3x3 stretch = StretchOf(ellipsoid.stretch);
    float3 center = Unstretched(stretch, ellipsoid.center_m - view.eye_m) / radius_m;
    float distance = length(center);
    float3 axis = center / distance;
    Impostor impostor;
    impostor.distance_m = distance;
    impostor.tan2 = 1.0 / (distance * distance - 1.0);
    impostor.ray = radius_m * mul(stretch, axis + sqrt(impostor.tan2) * AcrossAxis(axis, corner));
    impostor.drawn = IsSimulated(ellipsoid.tag) && distance > 1.0;
    return impostor;
}

#endif
