// A particle's sphere on a camera-facing triangle, in perspective.
#ifndef BROOKLET_IMPOSTOR
#define BROOKLET_IMPOSTOR

#include "../frame/camera.hlsl"

struct Impostor
{
    float3 ray;         // through the corner; length 1 along the line from the eye to the middle
    float distance_m;   // of the middle
    float tan2;         // tan^2 of the half angle that it is seen under
    bool drawn;         // not quarantined, and the eye is outside of it
};

Impostor impostor_of(FrameView view, float3 center_m, uint tag, float radius_m, float2 corner)
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
    impostor.drawn = (tag >> 31) == 0 && distance_m > radius_m;
    return impostor;
}

#endif
