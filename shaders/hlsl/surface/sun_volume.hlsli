// How much water sunlight has passed where it meets a point: the particles' volume in a grid over the sun's map
// (coordinates: column, row and distance from the sun's side, each 0..1), summed along the rays. A cell is two
// spacings or more, so that the tents of a lattice of particles add up evenly.
#ifndef BROOKLET_SUN_VOLUME
#define BROOKLET_SUN_VOLUME

#include "layout.hlsli"
#include "../frame/environment.hlsli"

// Where a point lies in the grid, in cells from the middle of the first one.
float3 SunCellPosition(FrameLight light, uint cells, float3 world_m)
{
    float3 at = ShadowPosition(light, world_m);
    return float3(at.xy, 1.0 - at.z) * float(cells) - 0.5;
}

// Cells of a ray lie one after the other, the sun's first.
uint SunCellIndex(uint cells, uint3 at)
{
    return (at.y * cells + at.x) * cells + at.z;
}

#endif
