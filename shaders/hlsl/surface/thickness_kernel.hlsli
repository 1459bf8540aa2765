// How a particle's volume d^3 is spread over a disc, for those who look through the fluid.
#ifndef BROOKLET_THICKNESS_KERNEL
#define BROOKLET_THICKNESS_KERNEL

#include "../shared/layout.hlsli"
#include "layout.hlsli"

// Around the center of what is drawn: a particle's ellipsoid, or its sphere.
struct Center
{
    float3 at_m;
    uint tag;
};

#if defined(ELLIPSOID_CENTERS)
StructuredBuffer<Ellipsoid> ellipsoids;

Center CenterOf(uint particle)
{
    Center center = { ellipsoids[particle].center_m, ellipsoids[particle].tag };
    return center;
}
#else
StructuredBuffer<Position> positions;

Center CenterOf(uint particle)
{
    Center center = { positions[particle].position_m, positions[particle].tag };
    return center;
}
#endif

// Thickness at a point of the unit disc, in spacings; 0 outside. (1 - s)^2 is smooth at the rim, and
// its integral over a disc of radius r is pi r^2 / 3.
float ThicknessKernel(float2 disc, SurfaceParams surface)
{
    float inside = saturate(1.0 - dot(disc, disc));
    float ratio = surface.spacing_m / surface.thickness_radius_m;
    return 0.95492966 * ratio * ratio * inside * inside;
}

#endif
