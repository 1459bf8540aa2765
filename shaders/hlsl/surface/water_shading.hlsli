// The water: how light leaves a point of its surface toward the eye. Whoever finds that point, by
// depth or by triangles, shades it here.
//
// C = (1 - F) lerp(C_fluid, S, exp(-absorption T)) + F R + highlight: transmission of what lies
// behind through thickness T (Beer-Lambert) and the water's own colour, the environment's
// reflection, Fresnel's share F of each.
#ifndef BROOKLET_WATER_SHADING
#define BROOKLET_WATER_SHADING

#include "layout.hlsli"
#include "water_optics.hlsli"
#include "../frame/camera.hlsli"
#include "../frame/environment.hlsli"

struct WaterPoint
{
    float3 position_m;
    float3 normal;          // toward the eye's side
    float3 to_eye;
    float thickness_m;      // of the water along the line of sight
    float3 sunlight;        // share of the sun's light that arrives through other water (Beer-Lambert)
};

// A ring of tall soft windows around the scene, as a photographer lights glass: what calm water
// mirrors toward any camera is brighter than the floor seen through it, and waves bend the
// windows' outlines into highlights.
float3 Windows(FrameLight light, float3 direction)
{
    float height = smoothstep(0.10, 0.22, direction.y) * (1.0 - smoothstep(0.50, 0.75, direction.y));
    float2 around = direction.xz * rsqrt(max(dot(direction.xz, direction.xz), 1e-6));
    // cos 3a without the angle: three windows, with the sun's side brightest.
    float three = around.x * (4.0 * around.x * around.x - 3.0);
    float open = 0.35 + 0.65 * smoothstep(-0.35, 0.25, three);
    return height * open * (1.1 * light.sky_horizon + 0.12 * light.sun_color);
}

// What a mirrored ray meets: the sky, or the floor as light falls on it on the whole.
float3 Surroundings(FrameLight light, FrameStyle style, float3 position_m, float3 direction)
{
    float3 sky = SkyRadiance(light, direction) + Windows(light, direction);
    float3 ambient = 1.5 * lerp(light.sky_horizon, light.sky_zenith, 0.4);
    float3 floor_light = style.floor_color * (0.75 * light.to_sun.y * light.sun_color + 0.75 * ambient);
    // The floor melts into the horizon as it does in the picture.
    float away_m = position_m.y / max(-direction.y, 1e-4);
    float fade = exp(-away_m * away_m / (style.floor_fade_m * style.floor_fade_m));
    return lerp(sky, floor_light, smoothstep(0.0, 0.04, -direction.y) * fade);
}

// Where the line of sight, refracted at the surface, has gone through the water or met the floor:
// beta = gamma T, with Snell's direction for the normal's part in the screen.
float3 RefractedEnd(WaterStyle water, WaterPoint point_)
{
    float3 straight = -point_.to_eye;
    float3 bent = refract(straight, point_.normal, AIR_OVER_WATER);
    float3 direction = lerp(straight, bent, water.refraction);
    float to_floor_m = direction.y < -1e-4 ? max(point_.position_m.y, 0.0) / -direction.y : 1e9;
    return point_.position_m + direction * min(point_.thickness_m, to_floor_m);
}

// GGX (Walter et al. 2007) with Smith's visibility as one factor (Karis 2013): the sun's highlight.
float3 SunHighlight(FrameLight light, WaterStyle water, WaterPoint point_)
{
    float3 halfway = normalize(light.to_sun + point_.to_eye);
    float n_h = saturate(dot(point_.normal, halfway));
    float n_l = saturate(dot(point_.normal, light.to_sun));
    float n_v = saturate(dot(point_.normal, point_.to_eye));
    float alpha = water.roughness * water.roughness;
    float alpha2 = alpha * alpha;
    float d = n_h * n_h * (alpha2 - 1.0) + 1.0;
    float distribution = alpha2 / (3.14159265 * d * d);
    float k = 0.5 * alpha;
    float visibility = 0.25 / ((n_l * (1.0 - k) + k) * (n_v * (1.0 - k) + k));
    float f = Fresnel(WATER_F0, dot(halfway, light.to_sun));
    // No brighter than film can tell: one pixel must not outshine those around it.
    return min(distribution * visibility * f * n_l * light.sun_color, 12.0) * point_.sunlight;
}

// What the water shows of its own: light of sun and sky scattered back from inside.
float3 WaterGlow(FrameLight light, FrameStyle style, WaterStyle water, WaterPoint point_)
{
    float3 ambient = AmbientLight(light, style.floor_color, point_.normal);
    float wrapped = saturate(0.6 + 0.4 * dot(point_.normal, light.to_sun));
    // Toward the sun thin crests light up from behind.
    float through = saturate(-dot(point_.to_eye, light.to_sun));
    return water.scatter_color * (ambient + (0.5 * wrapped + 0.5 * through * through) * point_.sunlight * light.sun_color);
}

// `behind` is the radiance that arrives at the refracted line's end.
float3 WaterRadiance(FrameLight light, FrameStyle style, WaterStyle water, WaterPoint point_, float3 behind)
{
    float f = Fresnel(WATER_F0, dot(point_.normal, point_.to_eye));
    float3 mirrored = reflect(-point_.to_eye, point_.normal);
    float3 passed = exp(-water.absorption_per_m * point_.thickness_m);
    float milky = exp(-water.scatter_per_m * point_.thickness_m);
    float3 inside = lerp(WaterGlow(light, style, water, point_), behind * passed, milky);
    return (1.0 - f) * inside + f * Surroundings(light, style, point_.position_m, mirrored)
        + SunHighlight(light, water, point_);
}

#endif
