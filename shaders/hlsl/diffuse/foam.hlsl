// The diffuse particles over the picture: as much of them as their optical depth hides (1 - exp(-depth)), white by sun and sky. Where
// the depth falls away toward the sun a bank of foam is lit, away from it shaded: it is not a flat white.
#pragma vertex FoamVertex
#pragma fragment FoamFragment
#pragma multi_compile _ SOLIDS_SHADOW

#include "../frame/covering.hlsli"
#include "../frame/environment.hlsli"
#if defined(SOLIDS_SHADOW)
#include "../frame/sun_past.hlsli"
#endif

Texture2D<float4> diffuse_light;    // premultiplied with optical depth, which is its alpha
#if defined(SOLIDS_SHADOW)
Texture2D<float> inverse_depth;
Texture2D<float> solids_shadow_map;
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;

static const float FOAM_ALBEDO = 0.92;

Varyings FoamVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

float DepthAt(int2 pixel)
{
    return diffuse_light.Load(int3(clamp(pixel, 0, int2(view.size_px) - 1), 0)).a;
}

float4 FoamFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float4 seen = diffuse_light.Load(int3(pixel, 0));
    if (seen.a <= 0.002)
        discard;
    float coverage = 1.0 - exp(-seen.a);
    float3 tint = seen.rgb / seen.a;

    // The bank's slope over the screen, of its hiding: bounded where it is thick.
    float2 slope = float2(exp(-DepthAt(pixel - int2(1, 0))) - exp(-DepthAt(pixel + int2(1, 0))),
                          exp(-DepthAt(pixel + int2(0, 1))) - exp(-DepthAt(pixel - int2(0, 1))));
    float3 normal = normalize(float3(0.0, 1.0, 0.0) - 0.5 * view.forward - 0.8 * (slope.x * view.right + slope.y * view.up));
    float sunlit = 0.35 + 0.65 * saturate(dot(normal, light.to_sun));
#if defined(SOLIDS_SHADOW)
    float here = inverse_depth.Load(int3(pixel, 0));
    float2 at = float2(2.0, -2.0) * input.position.xy / view.size_px + float2(-1.0, 1.0);
    if (here > 0.0)
        sunlit *= SunPastNear(solids_shadow_map, light, view.eye_m + RayThrough(view, at) / here, 0.0);
#endif
    float3 radiance = FOAM_ALBEDO * tint * (0.75 * sunlit * light.sun_color
        + 0.75 * AmbientLight(light, style.floor_color, normal));
    return float4(radiance, coverage);
}
