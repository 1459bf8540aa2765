// What a surface mirrors, of water or of metal: what surrounds it, and the sun.
#ifndef BROOKLET_REFLECTION
#define BROOKLET_REFLECTION

#include "../frame/environment.hlsli"

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

// What a mirrored ray meets: the sky, or a floor that shows `floor_light` there.
float3 SkyOrFloor(FrameLight light, FrameStyle style, float3 position_m, float3 direction, float3 floor_light)
{
    float3 sky = SkyRadiance(light, direction) + Windows(light, direction);
    // The floor melts into the horizon as it does in the picture.
    float away_m = position_m.y / max(-direction.y, 1e-4);
    float fade = exp(-away_m * away_m / (style.floor_fade_m * style.floor_fade_m));
    return lerp(sky, floor_light, smoothstep(0.0, 0.04, -direction.y) * fade);
}

// The same with the floor as light falls on it on the whole.
float3 Surroundings(FrameLight light, FrameStyle style, float3 position_m, float3 direction)
{
    float3 floor_light = style.floor_color * (0.75 * light.to_sun.y * light.sun_color + 0.75 * AmbientOnFloor(light));
    return SkyOrFloor(light, style, position_m, direction, floor_light);
}

// Share of each colour that a metal reflects: Schlick 1994.
float3 Fresnel(float3 f0, float cosine)
{
    return f0 + (1.0 - f0) * Fresnel(0.0, cosine);
}

// GGX (Walter et al. 2007) with Smith's visibility as one factor (Karis 2013): the sun in a surface that reflects the share
// `f0` at normal incidence.
float3 SunGlint(FrameLight light, float roughness, float3 normal, float3 to_eye, float3 f0)
{
    float3 halfway = normalize(light.to_sun + to_eye);
    float n_h = saturate(dot(normal, halfway));
    float n_l = saturate(dot(normal, light.to_sun));
    float n_v = saturate(dot(normal, to_eye));
    float alpha = roughness * roughness;
    float alpha2 = alpha * alpha;
    float d = n_h * n_h * (alpha2 - 1.0) + 1.0;
    float distribution = alpha2 / (3.14159265 * d * d);
    float k = 0.5 * alpha;
    float visibility = 0.25 / ((n_l * (1.0 - k) + k) * (n_v * (1.0 - k) + k));
    float3 f = Fresnel(f0, dot(halfway, light.to_sun));
    // No brighter than film can tell: one pixel must not outshine those around it.
    return min(distribution * visibility * f * n_l * light.sun_color, 12.0);
}

#endif
