// What the solids near a particle are to it while a substep's iterations move it: the half-space and the plane of its
// contact (boundary/solids/sample_solids.compute), counted as a wall is.
#ifndef BROOKLET_SOLID_SAMPLE
#define BROOKLET_SOLID_SAMPLE

#include "../../shared/layout.hlsli"
#include "beyond_plane.hlsli"
#include "layout.hlsli"

struct SolidSample
{
    float density;          // the density ratio that they add
    float3 gradient;        // of that over the position, 1/h
    float3 normal;          // out of them
    float moment;           // the slope of their share, times the distance in h
};

// Of the half-space at a place.
SolidSample SampleSolidsNear(SolidContact contact, float3 position_m, SmoothingKernelParams kernel)
{
    float distance = (dot(contact.normal, position_m) - contact.offset_m) * kernel.inverse_support_per_m;
    float2 beyond = BeyondPlane(distance, kernel);
    SolidSample solids;
    solids.density = kernel.wall_plane * beyond.x;
    solids.gradient = -kernel.wall_plane * beyond.y * contact.normal;
    solids.normal = contact.normal;
    solids.moment = kernel.wall_plane * beyond.y * saturate(distance);
    return solids;
}

// What the fluid's own neighbours push: along the solid as much more as the images behind it would add (AlongWalls).
float3 AlongSolids(SolidSample solids, float3 push)
{
    float scale = 1.0 / (1.0 - min(solids.density, 0.5));
    float3 across = solids.normal * dot(solids.normal, push);
    return across + scale * (push - across);
}

// What they bear of an acceleration across them (WallBorne).
float3 BorneBySolids(SolidSample solids, float3 acceleration_m_s2)
{
    return (solids.density + solids.moment) * dot(solids.normal, acceleration_m_s2) * solids.normal;
}

// The position, moved out of the nearest solid to where particles may be. Includers declare `solids_params`.
float3 OutsideSolids(SolidContact contact, float3 position_m)
{
    float gap_m = dot(contact.stop_normal, position_m) - contact.stop_offset_m - solids_params.stop_m;
    return position_m - contact.stop_normal * min(gap_m, 0.0);
}

#endif
