// The grid of photons over the sun's map, and the surface that they meet.
#ifndef BROOKLET_SUN_MAP
#define BROOKLET_SUN_MAP

#include "layout.hlsli"
#include "../frame/environment.hlsli"

// Shadow depth at a cell of the grid, 0 where no fluid is and outside.
float SunDepthAt(Texture2D<float> sun_depth, SurfaceParams surface, int2 at)
{
    bool inside = all(at >= 0) && all(at < int(surface.photons));
    return inside ? sun_depth.Load(int3(at, 0)) : 0.0;
}

// Surfaces within so many spacings of a wall are the wall.
static const float AT_WALL = 0.5;

// Where a ray of the sun enters the box of the walls.
struct Entry
{
    float depth;        // shadow depth there
    float3 outward;     // the wall's normal
    float wall_depth;   // what lies so much deeper, or less, is the wall
};

// The entry of the ray through a cell of the grid. Without walls it is infinitely far toward the sun.
Entry EntryAt(SurfaceParams surface, FrameLight light, int2 at)
{
    // From depth 0, toward the sun.
    float3 from_m = WorldFromShadow(light, float3((float2(at) + 0.5) / surface.photons, 0.0));
    float3 inverse = 1.0 / light.to_sun;
    float3 high_m = max((surface.wall_min_m - from_m) * inverse, (surface.wall_max_m - from_m) * inverse);
    float along_m = min(high_m.x, min(high_m.y, high_m.z));
    float3 axis = high_m.x == along_m ? float3(1.0, 0.0, 0.0)
        : (high_m.y == along_m ? float3(0.0, 1.0, 0.0) : float3(0.0, 0.0, 1.0));
    float cosine = dot(axis, light.to_sun);
    Entry entry;
    entry.depth = along_m / light.shadow_range_m;
    entry.outward = cosine < 0.0 ? -axis : axis;
    entry.wall_depth = AT_WALL * surface.spacing_m / (abs(cosine) * light.shadow_range_m);
    return entry;
}

// Whether a surface at this shadow depth is the wall's own.
bool IsWall(Entry entry, float depth)
{
    return depth > entry.depth - entry.wall_depth;
}

// Distance between two photons of the grid, m.
float PhotonSpacingM(SurfaceParams surface, FrameLight light)
{
    return light.shadow_texel_m * light.shadow_texels / surface.photons;
}

// Whether what sunlight meets at a cell, `there`, goes on the surface that it meets at `depth`, so many cells apart, and is
// no wall. A surface may fall by twice what it goes aside: the sun seldom stands lower.
bool IsSameSurface(SurfaceParams surface, FrameLight light, float depth, int2 at, float there, int apart)
{
    float range = (surface.range_m + 2.0 * abs(float(apart)) * PhotonSpacingM(surface, light)) / light.shadow_range_m;
    return there > 0.0 && abs(there - depth) < range && !IsWall(EntryAt(surface, light, at), there);
}

#endif
