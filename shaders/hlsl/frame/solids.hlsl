// The opaque solids: smooth paint in the light of sun and sky, shaded by each other and by the fluid.
#pragma vertex SolidsVertex
#pragma fragment SolidsFragment
#pragma multi_compile _ POINTS_SUN VOLUME_SUN

#include "solid_geometry.hlsli"
#include "camera.hlsli"
#include "sun_past.hlsli"

Texture2D<float> solids_shadow_map;
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;
#if defined(POINTS_SUN)
Texture2D<float> shadow_map;
#elif defined(VOLUME_SUN)
#include "../surface/sun_volume.hlsli"
StructuredBuffer<float> sun_volume;
ConstantBuffer<SunVolumeParams> volume;
ConstantBuffer<WaterStyle> water;
#endif
StructuredBuffer<uint> solid_indices;
StructuredBuffer<SolidVertex> solid_vertices;
StructuredBuffer<SolidPose> solid_poses;
StructuredBuffer<SolidPaint> solid_paints;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float3 world_m : TEXCOORD0;
    [[vk::location(1)]] float3 normal : TEXCOORD1;
    [[vk::location(2)]] float4 color_gloss : TEXCOORD2;
};

Varyings SolidsVertex(uint vertex : SV_VertexID)
{
    SolidVertex corner = solid_vertices[solid_indices[vertex]];
    SolidPose pose = solid_poses[corner.solid];
    Varyings output;
    output.world_m = SolidPositionOf(corner, pose);
    output.normal = SolidNormalOf(corner, pose);
    SolidPaint paint = solid_paints[corner.solid];
    output.color_gloss = float4(lerp(paint.color, paint.other, corner.rim), paint.gloss);
    output.position = ClipFromOffset(view, output.world_m - view.eye_m);
    return output;
}

// Share of the sun that arrives, of each color.
float3 SunArriving(float3 world_m, float3 normal)
{
    // Off the surface by as much as the map's own texels are wide.
    float3 above_m = world_m + 1.5 * light.shadow_texel_m * normal;
    float2 slope = SunSlope(light, normal);
    float3 arriving = SunPastNear(solids_shadow_map, light, above_m, slope);
#if defined(POINTS_SUN)
    // Particles that touch a surface reach over it in the map.
    float sun = SunPastNear(shadow_map, light, world_m + style.radius_m * normal, slope);
    arriving *= lerp(float3(0.05, 0.16, 0.24), float3(1.0, 1.0, 1.0), sun);
#elif defined(VOLUME_SUN)
    float through_m = WaterTowardSun(sun_volume, light, volume.cells, above_m, 0.0);
    arriving *= exp(-(water.absorption_per_m + water.scatter_per_m) * through_m);
#endif
    return arriving;
}

float4 SolidsFragment(Varyings input) : SV_Target0
{
    float3 normal = normalize(input.normal);
    float3 to_eye = normalize(view.eye_m - input.world_m);
    float n_dot_l = dot(normal, light.to_sun);
    float3 sun = 0.0;
    if (n_dot_l > 0.0)
        sun = SunArriving(input.world_m, normal) * light.sun_color;
    float n_dot_v = saturate(dot(normal, to_eye));
    // A weak light from the viewer keeps what is round so in the shade.
    float3 color = input.color_gloss.rgb * (0.75 * n_dot_l * sun + 0.85 * AmbientLight(light, style.floor_color, normal)
        + 0.25 * n_dot_v * n_dot_v * light.sky_horizon);
    float gloss = input.color_gloss.w;
    color += gloss * Fresnel(0.04, n_dot_v) * 0.6 * SkyGradient(light, reflect(-to_eye, normal));
    float3 halfway = normalize(light.to_sun + to_eye);
    color += gloss * 0.16 * Power64(saturate(dot(normal, halfway))) * sun;
    return float4(color, 1.0);
}
