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

// Water between the sun and a point, m. A point of the water's own surface is asked for a cell nearer to the sun, where
// the tents of the particles below it have ended.
float WaterTowardSun(StructuredBuffer<float> sun_volume, FrameLight light, uint cells, float3 world_m, float nearer)
{
    float3 at = SunCellPosition(light, cells, world_m);
    at.z -= nearer;
    at = clamp(at, 0.0, float(cells) - 1.001);
    uint3 low = uint3(at);
    float3 share = at - float3(low);
    float2 along[4];
    [unroll]
    for (uint i = 0; i < 4; i++)
    {
        uint first = SunCellIndex(cells, low + uint3(i & 1, i >> 1, 0));
        along[i] = float2(sun_volume[first], sun_volume[first + 1]);
    }
    float2 ray = lerp(lerp(along[0], along[1], share.x), lerp(along[2], along[3], share.x), share.y);
    return lerp(ray.x, ray.y, share.z);
}

#endif
