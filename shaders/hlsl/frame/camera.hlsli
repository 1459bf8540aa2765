// Projection by the camera's axes: cheaper than a matrix and exact to the same rounding.
#ifndef BROOKLET_CAMERA
#define BROOKLET_CAMERA

#include "layout.hlsli"

// Clip position of a point given relative to the eye.
float4 ClipFromOffset(FrameView view, float3 offset_m)
{
    float distance_m = dot(offset_m, view.forward);
    return float4(dot(offset_m, view.right) / view.tan_half_width,
                  dot(offset_m, view.up) / view.tan_half_height,
                  view.near_m, distance_m);
}

// Direction through a point of the picture in clip coordinates (-1..1, y up), with length 1 along
// `forward`.
float3 RayThrough(FrameView view, float2 ndc)
{
    return view.forward + ndc.x * view.tan_half_width * view.right + ndc.y * view.tan_half_height * view.up;
}

// Corner of a triangle that covers the picture.
float2 CoveringCorner(uint vertex)
{
    return float2(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0);
}

// Corner of a triangle around the unit circle: half the vertices of a quad, for discs of a few
// pixels drawn by the ten thousand.
float2 DiscCorner(uint vertex)
{
    return float2(vertex == 0 ? 0.0 : (vertex == 1 ? -1.7320508 : 1.7320508), vertex == 0 ? 2.0 : -1.0);
}

// Corner of a quad made of two triangles, in -1..1.
float2 QuadCorner(uint vertex)
{
    return float2((vertex == 1 || vertex == 3 || vertex == 5) ? 1.0 : -1.0,
                  (vertex == 2 || vertex == 4 || vertex == 5) ? 1.0 : -1.0);
}

#endif
