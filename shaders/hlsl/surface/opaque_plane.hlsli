// What is opaque behind the water, as the plane that touches it in a pixel.
#ifndef BROOKLET_OPAQUE_PLANE
#define BROOKLET_OPAQUE_PLANE

#include "normal.hlsli"

// The depth buffer as inverse_depth: reversed depth is near / distance, and 0 where nothing is opaque.
float OpaqueInverseDepthAt(Texture2D<float> scene_depth, FrameView view, int2 pixel)
{
    return InverseDepthAt(scene_depth, view.size_px, pixel) / view.near_m;
}

// N / c of the plane N . x = c that touches what is opaque in a pixel, x relative to the eye; 0 where
// nothing is. `range_m` as NormalAt's.
float3 OpaquePlaneAt(Texture2D<float> scene_depth, FrameView view, int2 pixel, float range_m)
{
    float here = OpaqueInverseDepthAt(scene_depth, view, pixel);
    if (here <= 0.0)
        return 0.0;
    float same = InverseDepthDifference(range_m, here);
    float along_x = Slope(OpaqueInverseDepthAt(scene_depth, view, pixel - int2(1, 0)), here,
                          OpaqueInverseDepthAt(scene_depth, view, pixel + int2(1, 0)), same);
    float along_y = -Slope(OpaqueInverseDepthAt(scene_depth, view, pixel - int2(0, 1)), here,
                           OpaqueInverseDepthAt(scene_depth, view, pixel + int2(0, 1)), same);
    return PlaneFromSlopes(view, pixel, here, float2(along_x, along_y));
}

// Share of a particle that is seen before the plane. Particles stay outside of what is opaque: one whose center
// lies on it is all before it. Those behind fade within `radius_m`, so that nothing pops.
float ShareBefore(float3 plane, float3 center_m, float radius_m)
{
    float inverse_distance = length(plane);
    if (inverse_distance <= 0.0)
        return 1.0;
    return smoothstep(-radius_m, 0.0, (1.0 - dot(plane, center_m)) / inverse_distance);
}

#endif
