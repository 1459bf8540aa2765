// Periodic axes: what leaves the domain on one side comes in on the other, and particles on either
// side of that seam are neighbours. A periodic side is a whole number of 4 h, after which quantized positions
// (quantized_position.hlsli) repeat, so that the iterations know nothing of it.
#ifndef BROOKLET_PERIODIC
#define BROOKLET_PERIODIC

#include "layout.hlsli"

// The position's image inside the domain.
float3 Wrapped(float3 position_m, StepParams step)
{
    float3 inside_m = position_m - step.period_m * floor(position_m * step.inverse_period_per_m);
    [unroll]
    for (uint axis = 0; axis < 3; ++axis)
    {
        // A rounding away from the seam, on either side of it, is on the seam.
        bool is_inside = inside_m[axis] >= 0.0 && inside_m[axis] < step.period_m[axis];
        if (step.period_m[axis] > 0.0 && !is_inside)
            inside_m[axis] = 0.0;
    }
    return inside_m;
}

// The shortest of what lies between two particles or any of their images.
float3 NearestImage(float3 offset_m, StepParams step)
{
    return offset_m - step.period_m * round(offset_m * step.inverse_period_per_m);
}

#endif
