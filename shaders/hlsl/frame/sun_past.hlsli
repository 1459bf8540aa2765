// Sunlight past what a shadow map holds.
#ifndef BROOKLET_SUN_PAST
#define BROOKLET_SUN_PAST

#include "environment.hlsli"
#include "sampling.hlsli"

// How shadow depth changes along a surface, over column and row of the map. At grazing light it is cut short.
float2 SunSlope(FrameLight light, float3 normal)
{
    float3 u = light.shadow_u.xyz, v = light.shadow_v.xyz;
    float2 aside = float2(dot(normal, u) / dot(u, u), dot(normal, v) / dot(v, v));
    return -aside / max(dot(normal, light.to_sun), 0.15) / light.shadow_range_m;
}

// Share of the sun that arrives: a disc of taps that widens with the blocker's distance, for a shadow that is crisp where
// what casts it stands on the surface and soft far from it. The disc is turned from pixel to pixel, which breaks the
// taps' pattern up. `slope` is the surface's (SunSlope): where the map holds it too, it does not shade itself.
float SunPast(Texture2D<float> shadow_map, FrameLight light, float3 world_m, float2 slope, float2 pixel)
{
    float3 at = ShadowPosition(light, world_m);
    if (any(abs(at.xy - 0.5) > 0.5))
        return 1.0;
    float own = max(at.z, 0.0) + 0.5 * light.shadow_texel_m / light.shadow_range_m;
    float texel = 1.0 / light.shadow_texels;
    float turn = 6.2831853 * PixelNoise(pixel);
    float2x2 turned = float2x2(cos(turn), -sin(turn), sin(turn), cos(turn));

    const uint probes = 6;
    float blockers = 0.0;
    float gap = 0.0;
    [unroll]
    for (uint i = 0; i < probes; i++)
    {
        float2 aside = 16.0 * texel * mul(turned, DiscTap(i, probes));
        float held = ShadowLoad(shadow_map, light, at.xy + aside);
        float depth = held - dot(slope, aside);
        // Where the map is empty nothing blocks, wherever a slope leads.
        float blocks = held > 0.0 ? step(own, depth) : 0.0;
        blockers += blocks;
        gap += blocks * (depth - own);
    }
    if (blockers == 0.0)
        return 1.0;
    float gap_m = gap / blockers * light.shadow_range_m;
    float soft = clamp(0.07 * gap_m / light.shadow_texel_m, 2.5, 16.0) * texel;

    const uint taps = 10;
    float shaded = 0.0;
    [unroll]
    for (uint k = 0; k < taps; k++)
    {
        float2 aside = soft * mul(turned, DiscTap(k, taps));
        float held = ShadowLoad(shadow_map, light, at.xy + aside);
        shaded += held > 0.0 ? step(own, held - dot(slope, aside)) : 0.0;
    }
    return 1.0 - shaded / taps;
}

// The same in a few taps, for what is not the floor: its shadows are as soft as the map is coarse.
float SunPastNear(Texture2D<float> shadow_map, FrameLight light, float3 world_m, float2 slope)
{
    float3 at = ShadowPosition(light, world_m);
    if (any(abs(at.xy - 0.5) > 0.5))
        return 1.0;
    float own = max(at.z, 0.0) + 0.5 * light.shadow_texel_m / light.shadow_range_m;
    const uint taps = 7;
    float shaded = 0.0;
    [unroll]
    for (uint k = 0; k < taps; k++)
    {
        float2 aside = 2.5 / light.shadow_texels * DiscTap(k, taps);
        float held = ShadowLoad(shadow_map, light, at.xy + aside);
        shaded += held > 0.0 ? step(own, held - dot(slope, aside)) : 0.0;
    }
    return 1.0 - shaded / taps;
}

#endif
