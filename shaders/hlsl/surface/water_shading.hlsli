// The water: how light leaves a point of its surface toward the eye. Whoever finds that point, by
// depth or by triangles, shades it here.
//
// C = (1 - F) lerp(C_fluid, S, exp(-absorption T)) + F R + highlight: transmission of what lies
// behind through thickness T (Beer-Lambert) and the water's own colour, the environment's
// reflection, Fresnel's share F of each.
#ifndef BROOKLET_WATER_SHADING
#define BROOKLET_WATER_SHADING

#include "layout.hlsli"
#include "reflection.hlsli"
#include "water_optics.hlsli"
#include "../frame/camera.hlsli"

struct WaterPoint
{
    float3 position_m;
    float3 normal;          // toward the eye's side
    float3 to_eye;
    float thickness_m;      // of the water along the line of sight
    float3 sunlight;        // share of the sun's light that arrives through other water (Beer-Lambert)
};

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
        + SunGlint(light, water.roughness, point_.normal, point_.to_eye, WATER_F0) * point_.sunlight;
}

#endif
