// The floor under the domain: satin tiles with the soft shadow of fluid and solids, melting into the horizon.
#pragma vertex FloorVertex
#pragma fragment FloorFragment
#pragma multi_compile _ POINTS_SHADOW WATER_SHADOW CAUSTICS_SHADOW
#pragma multi_compile _ SOLIDS_SHADOW

#include "camera.hlsli"
#include "environment.hlsli"
#include "floor_tiles.hlsli"
#include "sun_past.hlsli"

#if defined(POINTS_SHADOW)
Texture2D<float> shadow_map;
#elif defined(WATER_SHADOW)
#include "../surface/layout.hlsli"
Texture2D<float> sun_thickness;
SamplerState sampler_linear_clamp;
ConstantBuffer<SurfaceParams> surface;
ConstantBuffer<WaterStyle> water;
#elif defined(CAUSTICS_SHADOW)
#include "../surface/sun_map.hlsli"
Texture2D<float> sun_depth;
Texture2D<float4> caustics;
SamplerState sampler_linear_clamp;
ConstantBuffer<SurfaceParams> surface;
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;
#if defined(SOLIDS_SHADOW)
Texture2D<float> solids_shadow_map;
#endif

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float3 world_m : TEXCOORD0;
};

Varyings FloorVertex(uint vertex : SV_VertexID)
{
    // As wide as the fade lets anything be seen.
    float2 corner = QuadCorner(vertex) * style.floor_fade_m * 4.0;
    Varyings output;
    output.world_m = float3(0.5 * style.domain_size_m.x + corner.x, 0.0, 0.5 * style.domain_size_m.z + corner.y);
    output.position = ClipFromOffset(view, output.world_m - view.eye_m);
    return output;
}

#if defined(WATER_SHADOW)
// Sunlight after the water it went through: absorbed, and a part of it led elsewhere. The map has
// an empty margin, which clamping repeats: beyond it there is no water.
float3 SunThroughWater(float3 world_m, float2 pixel)
{
    float3 at = ShadowPosition(light, world_m);
    float turn = 6.2831853 * PixelNoise(pixel);
    float2x2 turned = float2x2(cos(turn), -sin(turn), sin(turn), cos(turn));
    // As wide as a particle's disc: the particles' own pattern is not to be seen.
    float soft = surface.thickness_radius_m / (light.shadow_texel_m * light.shadow_texels);
    const uint taps = 8;
    float spacings = 0.0;
    [unroll]
    for (uint i = 0; i < taps; i++)
        spacings += sun_thickness.SampleLevel(sampler_linear_clamp, at.xy + soft * mul(turned, DiscTap(i, taps)), 0.0);
    spacings /= taps;
    float3 passed = exp(-water.absorption_per_m * spacings * surface.spacing_m);
    return passed * lerp(0.55, 1.0, exp(-0.6 * spacings));
}
#elif defined(CAUSTICS_SHADOW)
// 1 where no water stands before the sun at a cell of the photons' grid.
float Dry(int2 at)
{
    return SunDepthAt(sun_depth, surface, at) > 0.0 ? 0.0 : 1.0;
}

// What photons that met no water would have brought, had they been drawn (their tents add up to the
// bilinear mean), and what the others brought.
float3 SunAndCaustics(float3 world_m)
{
    float2 uv = ShadowPosition(light, world_m).xy;
    float2 at = uv * surface.photons - 0.5;
    int2 low = int2(floor(at));
    float2 share = at - floor(at);
    float straight = lerp(lerp(Dry(low), Dry(low + int2(1, 0)), share.x),
                          lerp(Dry(low + int2(0, 1)), Dry(low + int2(1, 1)), share.x), share.y);
    return straight + caustics.SampleLevel(sampler_linear_clamp, uv, 0.0).rgb;
}
#endif

float4 FloorFragment(Varyings input) : SV_Target0
{
    float3 offset = input.world_m - view.eye_m;
    float distance_m = length(offset);
    float3 direction = offset / distance_m;
    float2 at = input.world_m.xz / style.tile_m;
    float3 albedo = FloorAlbedo(style, at, fwidth(at));

#if defined(POINTS_SHADOW)
    float sun = SunPast(shadow_map, light, input.world_m, 0.0, input.position.xy);
    // Sunlight that went through the fluid is not gone: it arrives blue.
    float3 arriving = lerp(float3(0.05, 0.16, 0.24), float3(1.0, 1.0, 1.0), sun);
#elif defined(WATER_SHADOW)
    float3 arriving = SunThroughWater(input.world_m, input.position.xy);
    float sun = dot(arriving, float3(0.2126, 0.7152, 0.0722));
#elif defined(CAUSTICS_SHADOW)
    float3 arriving = SunAndCaustics(input.world_m);
    // What is around does not grow brighter where rays meet.
    float sun = saturate(dot(arriving, float3(0.2126, 0.7152, 0.0722)));
#else
    float3 arriving = 1.0;
    float sun = 1.0;
#endif
#if defined(SOLIDS_SHADOW)
    float past = SunPast(solids_shadow_map, light, input.world_m, SunSlope(light, float3(0.0, 1.0, 0.0)), input.position.xy);
    arriving *= past;
    sun *= past;
#endif
    float3 up = float3(0.0, 1.0, 0.0);
    float3 ambient = AmbientOnFloor(light);
    float3 color = albedo * (light.to_sun.y * arriving * light.sun_color * 0.75 + ambient * (0.55 + 0.2 * sun));

    color = lerp(color, SkyGradient(light, reflect(direction, up)), Fresnel(0.04, -direction.y));
    color *= FloorLight(style, input.world_m);

    float fade = 1.0 - exp(-pow(distance_m / style.floor_fade_m, 2.0));
    color = lerp(color, SkyRadiance(light, normalize(float3(direction.x, 0.0, direction.z))), fade);
    return float4(color, 1.0);
}
