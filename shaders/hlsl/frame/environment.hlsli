// What surrounds the fluid, as every drawing stage sees it: sky, sun, and their light.
#ifndef BROOKLET_ENVIRONMENT
#define BROOKLET_ENVIRONMENT

#include "layout.hlsli"

// Where a ray leaves to: a gradient from horizon to zenith with a soft sun. Below the horizon it
// stays the horizon's colour, which is what the floor melts into.
float3 SkyGradient(FrameLight light, float3 direction)
{
    // Steep near the horizon, as a real sky's is. Squares, as `pow` is dear on a CPU driver.
    float below = 1.0 - saturate(direction.y);
    below *= below;
    return lerp(light.sky_zenith, light.sky_horizon, below * below);
}

// The same with the sun's glow.
float3 SkyRadiance(FrameLight light, float3 direction)
{
    float toward_sun = saturate(dot(direction, light.to_sun));
    float glow = 0.08 * pow(toward_sun, 6.0) + 0.25 * pow(toward_sun, 48.0) + 2.0 * pow(toward_sun, 900.0);
    return SkyGradient(light, direction) + glow * light.sun_color;
}

// Light of the sky on the floor.
float3 AmbientOnFloor(FrameLight light)
{
    return 1.5 * lerp(light.sky_horizon, light.sky_zenith, 0.4);
}

// x to the power of 64.
float Power64(float x)
{
    x *= x;
    x *= x;
    x *= x;
    x *= x;
    x *= x;
    return x * x;
}

// Diffuse light of sky and floor on a surface facing `normal`.
float3 AmbientLight(FrameLight light, float3 floor_color, float3 normal)
{
    // Brighter than the part of the sky that is seen, as a studio is lit from above.
    float3 sky = 1.5 * lerp(light.sky_horizon, light.sky_zenith, 0.5);
    float3 bounce = floor_color * (0.35 * light.sun_color + 0.3 * light.sky_horizon);
    return lerp(bounce, sky, 0.5 + 0.5 * normal.y);
}

// Share of light a smooth dielectric reflects: Schlick 1994.
float Fresnel(float f0, float cosine)
{
    float x = 1.0 - saturate(cosine);
    float x2 = x * x;
    return f0 + (1.0 - f0) * x2 * x2 * x;
}

// Column and row in the shadow map, and depth there (1 nearest the sun).
float3 ShadowPosition(FrameLight light, float3 world_m)
{
    float4 p = float4(world_m, 1.0);
    return float3(dot(light.shadow_u, p), dot(light.shadow_v, p), dot(light.shadow_depth, p));
}

// The position in the world of a point of the shadow map. Its rows stand at right angles, each
// with the length of its inverse scale.
float3 WorldFromShadow(FrameLight light, float3 at)
{
    float3 u = light.shadow_u.xyz, v = light.shadow_v.xyz, depth = light.shadow_depth.xyz;
    return u * ((at.x - light.shadow_u.w) / dot(u, u)) + v * ((at.y - light.shadow_v.w) / dot(v, v))
        + depth * ((at.z - light.shadow_depth.w) / dot(depth, depth));
}

// Clip position of a point of the shadow map.
float4 ClipFromShadow(float3 at)
{
    return float4(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y, at.z, 1.0);
}

// Depth of the map's texel at `uv`; zero (nothing there) outside.
float ShadowLoad(Texture2D<float> shadow_map, FrameLight light, float2 uv)
{
    float2 texel = clamp(uv * light.shadow_texels, 0.0, light.shadow_texels - 1.0);
    return shadow_map.Load(int3(int2(texel), 0));
}

#endif
