// A fluid of metal as it is seen: light that meets it is mirrored or gone, so nothing is read of what lies behind it, nor how
// thick it is. Alpha is 1 there. What is opaque and in front stays in front.
//
// C = F R + highlight: what surrounds it R, and the metal's own share F of each colour (Schlick 1994).
#pragma vertex MetalVertex
#pragma fragment MetalFragment
#pragma multi_compile _ MESH_NORMALS
#pragma multi_compile _ SOLIDS_SHADOW

#include "layout.hlsli"
#include "inverse_depth.hlsli"
#include "normal.hlsli"
#include "reflection.hlsli"
#include "../frame/covering_ray.hlsli"
#include "../frame/floor_tiles.hlsli"
#if defined(SOLIDS_SHADOW)
#include "../frame/sun_past.hlsli"
#endif

Texture2D<float> inverse_depth;
Texture2D<float> scene_depth;
Texture2D<float> sun_thickness;
SamplerState sampler_linear_clamp;
#if defined(MESH_NORMALS)
Texture2D<float4> mesh_normals;
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;
ConstantBuffer<SurfaceParams> surface;
ConstantBuffer<WaterStyle> water;
#if defined(SOLIDS_SHADOW)
Texture2D<float> solids_shadow_map;
#endif

Varyings MetalVertex(uint vertex : SV_VertexID)
{
    return CoveringRay(view, vertex);
}

// What a mirrored ray meets: the sky, or the floor with its tiles and with the fluid's shadow on it.
float3 Mirrored(float3 position_m, float3 direction)
{
    float down = max(-direction.y, 1e-4);
    float3 floor_m = position_m + direction * (max(position_m.y, 0.0) / down);
    float2 at = floor_m.xz / style.tile_m;
    float3 albedo = FloorAlbedo(style, at, fwidth(at));
    float spacings = sun_thickness.SampleLevel(sampler_linear_clamp, ShadowPosition(light, floor_m).xy, 0.0);
    float3 sun = light.to_sun.y * light.sun_color * exp(-water.absorption_per_m * spacings * surface.spacing_m);
    // What mirrors the floor hides the sky from it, the more the steeper it looks down.
    float3 ambient = (1.0 - 0.6 * down) * AmbientOnFloor(light);
    float3 floor_light = albedo * (0.75 * sun + 0.75 * ambient) * FloorLight(style, floor_m);
    return SkyOrFloor(light, style, position_m, direction, floor_light);
}

float4 MetalFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = InverseDepthAt(inverse_depth, view.size_px, pixel);
    float3 position_m = view.eye_m + input.ray / max(here, 1e-12);
    float3 to_eye = -normalize(input.ray);
#if defined(MESH_NORMALS)
    float3 normal = mesh_normals.Load(int3(pixel, 0)).xyz;
#else
    float3 normal = NormalAt(inverse_depth, view, pixel, here, surface.range_m);
#endif
    float3 mirrored = Fresnel(water.reflectance, dot(normal, to_eye)) * Mirrored(position_m, reflect(-to_eye, normal));
    float3 glint = SunGlint(light, water.roughness, normal, to_eye, water.reflectance);
#if defined(SOLIDS_SHADOW)
    glint *= SunPastNear(solids_shadow_map, light, position_m, 0.0);
#endif
    // Last: `fwidth` asks what neighbours see of the floor.
    if (!IsBeforeScene(scene_depth, view, pixel, here))
        discard;
    return float4(mirrored + glint, 1.0);
}
