// How much of the kernel lies beyond a plane, from either side of it.
#ifndef BROOKLET_BEYOND_PLANE
#define BROOKLET_BEYOND_PLANE

#include "../../shared/layout.hlsli"

// Of the kernel beyond a plane at a signed distance in h, and how much it shrinks with that (boundary/walls.hlsli).
float2 BeyondPlane(float distance, SmoothingKernelParams kernel)
{
    float reach = saturate(1.0 - abs(distance));
    float4 of = kernel.wall_kernel_fraction;
    float reach4 = reach * reach * (reach * reach);
    float share = reach4 * reach * (of.x + reach * (of.y + reach * (of.z + reach * of.w)));
    float slope = reach4 * (5.0 * of.x + reach * (6.0 * of.y + reach * (7.0 * of.z + reach * 8.0 * of.w)));
    return float2(distance < 0.0 ? 1.0 - share : share, slope);
}

#endif
