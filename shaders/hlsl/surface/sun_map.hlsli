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

// Distance between two photons of the grid, m.
float PhotonSpacingM(SurfaceParams surface, FrameLight light)
{
    return light.shadow_texel_m * light.shadow_texels / surface.photons;
}

#endif
