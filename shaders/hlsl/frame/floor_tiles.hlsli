// The floor's tiles and the light on them, for whoever sees the floor itself or mirrored.
#ifndef BROOKLET_FLOOR_TILES
#define BROOKLET_FLOOR_TILES

#include "layout.hlsli"

// How much of a pixel's footprint `width` (in tiles) around `at` lies on a joint that takes
// `joint` of each tile: the integral over the footprint, so that it fades out and never flickers.
float2 JointIntegral(float2 x, float joint)
{
    return floor(x) * joint + min(frac(x), joint);
}

float Joints(float2 at, float2 width, float joint)
{
    float2 share = (JointIntegral(at + 0.5 * width, joint) - JointIntegral(at - 0.5 * width, joint)) / width;
    return 1.0 - (1.0 - saturate(share.x)) * (1.0 - saturate(share.y));
}

float TileTone(float2 tile)
{
    float2 h = frac(tile * float2(0.1031, 0.1130) + 0.37);
    h += dot(h, h.yx + 33.33);
    return frac((h.x + h.y) * h.x * 7.13);
}

// Colour of the floor at a place in tiles, over a pixel's footprint in tiles.
float3 FloorAlbedo(FrameStyle style, float2 at, float2 footprint)
{
    float2 width = max(footprint, 1e-4);
    float near = saturate(1.0 - max(width.x, width.y) * 1.5);
    float3 albedo = style.floor_color * (1.0 + 0.16 * near * (TileTone(floor(at)) - 0.5));
    return albedo * (1.0 - 0.40 * Joints(at, width, 0.022));
}

// A pool of light around the domain: what is to be looked at is brightest.
float FloorLight(FrameStyle style, float3 world_m)
{
    float away = length(world_m.xz - 0.5 * style.domain_size_m.xz) / (0.4 * style.floor_fade_m);
    return 0.5 + 0.6 / (1.0 + away * away);
}

#endif
