// A surface seen from the eye as one number a pixel: its inverse_depth, 1 / distance along `forward`,
// in 1/m; 0 where nothing is, which is infinitely far. Planes are linear in it however tilted, so
// a symmetric filter leaves calm water exactly as it is, where one of the distance would bend it
// toward the eye; and f32 keeps 24 bits of it at any distance.
#ifndef BROOKLET_INVERSE_DEPTH
#define BROOKLET_INVERSE_DEPTH

#include "../frame/layout.hlsli"

// The inverse_depth at a pixel, 0 outside the picture.
float InverseDepthAt(Texture2D<float> inverse_depth, float2 size_px, int2 pixel)
{
    bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < int(size_px.x) && pixel.y < int(size_px.y);
    return inside ? inverse_depth.Load(int3(pixel, 0)) : 0.0;
}

// Whether a surface is there, and nothing opaque of the scene before it: reversed depth is near / distance.
bool IsBeforeScene(Texture2D<float> scene_depth, FrameView view, int2 pixel, float here)
{
    return here > 0.0 && scene_depth.Load(int3(pixel, 0)) <= 1.0005 * view.near_m * here;
}

// A small difference of distance as one of inverse_depth: d(1/z) = dz / z^2. Never more than half the
// inverse_depth itself, so that what is near the eye keeps apart from nothing at all.
float InverseDepthDifference(float distance_m, float inverse_depth)
{
    return min(distance_m * inverse_depth * inverse_depth, 0.5 * inverse_depth);
}

// Reach of a filter in pixels: `reach_m` in the world, whatever the distance and the resolution.
float ReachPx(float reach_m, float inverse_depth, float pixel_angle, float most_px)
{
    return min(reach_m * inverse_depth / pixel_angle, most_px);
}

// Weight at a distance from the filter's middle: a Gaussian of which the reach is two standard
// deviations, lowered to be zero there. So a tap comes in at nothing as the reach grows from pixel
// to pixel and frame to frame, and nothing pops.
float SpatialWeight(float squared_px, float reach)
{
    return max(exp(-2.0 * squared_px / (reach * reach)) - 0.13533528, 0.0);
}

// The same of the pixel in the middle.
static const float MIDDLE_WEIGHT = 0.86466472;

#endif
