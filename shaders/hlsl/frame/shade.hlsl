// The particles' colours: each pixel in which one is seen is shaded once.
#pragma vertex ShadeVertex
#pragma fragment ShadeFragment
#pragma multi_compile _ COLOR_FLUID COLOR_DENSITY
#pragma multi_compile _ SOLIDS_SHADOW

#include "../shared/layout.hlsli"
#include "covering_ray.hlsli"
#include "environment.hlsli"
#include "palette.hlsli"
#if defined(SOLIDS_SHADOW)
#include "sun_past.hlsli"
#endif

Texture2D<float> seen;      // index + 1 of the particle seen in a pixel, 0 where there is none
StructuredBuffer<Position> positions;
#if defined(COLOR_DENSITY)
StructuredBuffer<float> density_ratios;
#elif !defined(COLOR_FLUID)
StructuredBuffer<Velocity> velocities;
#endif
Texture2D<float> shadow_map;
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;
#if defined(SOLIDS_SHADOW)
Texture2D<float> solids_shadow_map;
#endif

Varyings ShadeVertex(uint vertex : SV_VertexID)
{
    return CoveringRay(view, vertex);
}

// Share of the sun that reaches a particle: it fades with the depth of fluid in front of it, as
// light does in water, rather than stopping at the first particle.
float SunReaching(float3 world_m)
{
    float3 at = ShadowPosition(light, world_m);
    float own_radius = style.radius_m / light.shadow_range_m;
    float reach = 2.2 * style.radius_m / (light.shadow_texel_m * light.shadow_texels);
    const float2 taps[5] = { float2(0.0, 0.0), float2(0.9, 0.4), float2(-0.4, 0.9), float2(-0.9, -0.4), float2(0.4, -0.9) };
    float sum = 0.0;
    [unroll]
    for (uint i = 0; i < 5; i++)
    {
        float front = ShadowLoad(shadow_map, light, at.xy + reach * taps[i]);
        float depth_m = max(0.0, front - at.z - 2.0 * own_radius) * light.shadow_range_m;
        sum += exp(-depth_m / style.light_depth_m);
    }
    return sum / 5.0;
}

float3 Shade(float3 normal, float3 to_eye, float3 albedo, float sun)
{
    float n_dot_l = dot(normal, light.to_sun);
    float n_dot_v = saturate(dot(normal, to_eye));
    // Wrapped diffuse: light that enters the drop leaves it beyond the terminator.
    float wrapped = saturate((n_dot_l + 0.35) / 1.35);
    // A weak light from the viewer keeps the drops round in the shade.
    float3 color = albedo * (wrapped * wrapped * sun * light.sun_color * 0.9
        + AmbientLight(light, style.floor_color, normal) * (0.5 + 0.5 * sun)
        + 0.22 * n_dot_v * n_dot_v * light.sky_horizon);
    // Water glows a little where the sun comes through from behind.
    float through = saturate(-dot(to_eye, light.to_sun)) * saturate(0.6 - n_dot_l);
    color += sqrt(albedo) * float3(0.10, 0.32, 0.36) * through * sun * light.sun_color * 0.35;
    float f = Fresnel(0.02, n_dot_v);
    // Deep in the fluid a drop mirrors its neighbours and not the sky.
    color += f * SkyGradient(light, reflect(-to_eye, normal)) * (0.04 + 0.8 * sun * sun);
    float3 halfway = normalize(light.to_sun + to_eye);
    color += Power64(saturate(dot(normal, halfway))) * 0.45 * sun * light.sun_color;
    return color;
}

float4 ShadeFragment(Varyings input) : SV_Target0
{
    float index = seen.Load(int3(int2(input.position.xy), 0));
    if (index < 0.5)
        discard;
    uint particle = uint(index) - 1u;
    Position found = positions[particle];
    float3 center_m = found.position_m - view.eye_m;
    float3 direction = normalize(input.ray);
    // The middle's distance from the ray, by its components and not by lengths that cancel.
    float3 aside_m = center_m - dot(direction, center_m) * direction;
    float half_chord_m = sqrt(max(style.radius_m * style.radius_m - dot(aside_m, aside_m), 0.0));
    float3 normal = -normalize(aside_m + half_chord_m * direction);
#if defined(COLOR_FLUID)
    float3 albedo = FluidColor((found.tag >> 24) & 127u);
#elif defined(COLOR_DENSITY)
    float3 albedo = DensityColor(density_ratios[particle]);
#else
    float3 albedo = SpeedColor(length(velocities[particle].velocity_m_s) * style.inverse_speed_scale_s_m);
#endif
    float sun = SunReaching(found.position_m);
#if defined(SOLIDS_SHADOW)
    sun *= SunPastNear(solids_shadow_map, light, found.position_m, 0.0);
#endif
    return float4(Shade(normal, -direction, albedo, sun), 1.0);
}
