// The surface's normal from its inverse_depth w, in f32. On a plane N . x = c every ray r (1 along
// forward) meets x = r / w with w = (N . r) / c: so w's slopes over r are N's components, without
// the differences of positions that cancel far away.
#ifndef BROOKLET_NORMAL
#define BROOKLET_NORMAL

#include "inverse_depth.hlsli"

// Slope of the inverse_depth across a pixel, from those before and after. Where both lie on one surface
// it is the central difference; at an edge the smaller of the one-sided ones, which looks along the
// surface and not over its edge (van der Laan, Green & Sainz 2009, section 4.2).
float Slope(float before, float here, float after, float same)
{
    float backward = before > 0.0 ? here - before : 1e30;
    float forward = after > 0.0 ? after - here : 1e30;
    if (max(abs(backward), abs(forward)) < same)
        return 0.5 * (backward + forward);
    float smaller = abs(backward) < abs(forward) ? backward : forward;
    return abs(smaller) < 1e29 ? smaller : 0.0;
}

// N / c of the plane N . x = c, x relative to the eye and in world axes, whose inverse_depth is `here` at a
// pixel and grows by `slopes` to the next one, rightward and upward.
float3 PlaneFromSlopes(FrameView view, int2 pixel, float here, float2 slopes)
{
    float2 ndc = (float2(pixel) + 0.5) / view.size_px * float2(2.0, -2.0) + float2(-1.0, 1.0);
    float2 ray = ndc * float2(view.tan_half_width, view.tan_half_height);
    // Pixels are 2 tan_half / size apart in the ray's coordinates.
    float2 gradient = slopes * (0.5 * view.size_px / float2(view.tan_half_width, view.tan_half_height));
    float ahead = here - dot(gradient, ray);
    return gradient.x * view.right + gradient.y * view.up + ahead * view.forward;
}

// Normal toward the eye at a pixel with inverse_depth `here` above 0, in world axes.
float3 NormalAt(Texture2D<float> inverse_depth, FrameView view, int2 pixel, float here, float range_m)
{
    float same = InverseDepthDifference(range_m, here);
    float along_x = Slope(InverseDepthAt(inverse_depth, view.size_px, pixel - int2(1, 0)), here,
                          InverseDepthAt(inverse_depth, view.size_px, pixel + int2(1, 0)), same);
    // Rows count downward, the picture's y upward.
    float along_y = -Slope(InverseDepthAt(inverse_depth, view.size_px, pixel - int2(0, 1)), here,
                           InverseDepthAt(inverse_depth, view.size_px, pixel + int2(0, 1)), same);
    return -normalize(PlaneFromSlopes(view, pixel, here, float2(along_x, along_y)));
}

#endif
