// The water as it is seen: every pixel that the smoothed surface covers, shaded once, over the scene
// behind it. Alpha is 1 there. What is opaque and in front stays in front.
#pragma vertex WaterVertex
#pragma fragment WaterFragment
#pragma multi_compile _ MESH_NORMALS
#pragma multi_compile _ SELF_SHADOW
#pragma multi_compile _ SOLIDS_SHADOW

#include "inverse_depth.hlsli"
#include "normal.hlsli"
#include "water_shading.hlsli"
#include "../frame/covering_ray.hlsli"
#if defined(SELF_SHADOW)
#include "sun_volume.hlsli"
#endif
#if defined(SOLIDS_SHADOW)
#include "../frame/sun_past.hlsli"
#endif

Texture2D<float> inverse_depth;
Texture2D<float> thickness;
Texture2D<float4> scene;
Texture2D<float> scene_depth;
#if defined(MESH_NORMALS)
Texture2D<float4> mesh_normals;
#endif
#if defined(SELF_SHADOW)
StructuredBuffer<float> sun_volume;
ConstantBuffer<SunVolumeParams> volume;
#endif
SamplerState sampler_linear_clamp;
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;
ConstantBuffer<SurfaceParams> surface;
ConstantBuffer<WaterStyle> water;
#if defined(SOLIDS_SHADOW)
Texture2D<float> solids_shadow_map;
#endif

Varyings WaterVertex(uint vertex : SV_VertexID)
{
    return CoveringRay(view, vertex);
}

// The scene where a point is seen: what is opaque and in front of the water is not behind it. The refracted line that
// passes what the straight one meets, by a body's edge, goes on through the water behind: `thickness_m` grows.
float3 SceneBehind(float3 end_m, int2 own_px, float here, inout float thickness_m)
{
    float4 clip = ClipFromOffset(view, end_m - view.eye_m);
    float2 at = clip.w > view.near_m ? float2(0.5, -0.5) * clip.xy / clip.w + 0.5 : -1.0;
    bool seen = all(at > 0.0) && all(at < 1.0);
    float own_depth = scene_depth.Load(int3(own_px, 0));
    float depth = seen ? scene_depth.Load(int3(int2(at * view.size_px), 0)) : own_depth;
    if (!seen || depth > view.near_m * here)
        return scene.Load(int3(own_px, 0)).rgb;
    float past_m = view.near_m / max(depth, 1.0e-6) - view.near_m / max(own_depth, 1.0e-6);
    float there_m = thickness.SampleLevel(sampler_linear_clamp, at, 0.0) * surface.spacing_m;
    thickness_m += clamp(there_m - thickness_m, 0.0, max(past_m, 0.0));
    return scene.SampleLevel(sampler_linear_clamp, at, 0.0).rgb;
}

float4 WaterFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = InverseDepthAt(inverse_depth, view.size_px, pixel);
    if (!IsBeforeScene(scene_depth, view, pixel, here))
        discard;
    WaterPoint point_;
    point_.position_m = view.eye_m + input.ray / here;
    point_.to_eye = -normalize(input.ray);
#if defined(MESH_NORMALS)
    point_.normal = mesh_normals.Load(int3(pixel, 0)).xyz;
#else
    point_.normal = NormalAt(inverse_depth, view, pixel, here, surface.range_m);
#endif
    float2 uv = input.position.xy / view.size_px;
    point_.thickness_m = thickness.SampleLevel(sampler_linear_clamp, uv, 0.0) * surface.spacing_m;
#if defined(SELF_SHADOW)
    point_.sunlight = exp(-(water.absorption_per_m + water.scatter_per_m) * WaterTowardSun(sun_volume, light, volume.cells, point_.position_m, 1.0));
#else
    point_.sunlight = 1.0;
#endif
#if defined(SOLIDS_SHADOW)
    point_.sunlight *= SunPastNear(solids_shadow_map, light, point_.position_m, 0.0);
#endif
    float3 behind = SceneBehind(RefractedEnd(water, point_), pixel, here, point_.thickness_m);
    return float4(WaterRadiance(light, style, water, point_, behind), 1.0);
}
