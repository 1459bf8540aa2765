// Solids of glass: a film that mirrors more the flatter it is looked along, a little darker there and at rims. It is drawn
// in halves: its far faces, then its near ones; with water what lies behind it before it, to be refracted, and what lies
// in front over it.
#pragma vertex GlassVertex
#pragma fragment GlassFragment
#pragma multi_compile _ BEHIND_WATER BEFORE_WATER

#include "solid_geometry.hlsli"
#include "camera.hlsli"
#include "../surface/water_shading.hlsli"

#if defined(BEHIND_WATER) || defined(BEFORE_WATER)
#define WATER
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;
#if defined(WATER)
Texture2D<float> inverse_depth;
#endif
StructuredBuffer<uint> solid_indices;
StructuredBuffer<SolidVertex> solid_vertices;
StructuredBuffer<SolidPose> solid_poses;
StructuredBuffer<SolidPaint> solid_paints;

// Reflectance at normal incidence, n = 1.5.
static const float GLASS_F0 = 0.04;
// Light that a face keeps, looked at straight, and a rim.
static const float FACE_DEPTH = 0.012;
static const float RIM_DEPTH = 0.3;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float3 world_m : TEXCOORD0;
    [[vk::location(1)]] float3 normal : TEXCOORD1;
    [[vk::location(2)]] nointerpolation float4 color_rim : TEXCOORD2;
};

Varyings GlassVertex(uint vertex : SV_VertexID)
{
    SolidVertex corner = solid_vertices[solid_indices[vertex]];
    SolidPose pose = solid_poses[corner.solid];
    Varyings output;
    output.world_m = SolidPositionOf(corner, pose);
    output.normal = SolidNormalOf(corner, pose);
    output.color_rim = float4(solid_paints[corner.solid].color, corner.rim);
    output.position = ClipFromOffset(view, output.world_m - view.eye_m);
    return output;
}

float4 GlassFragment(Varyings input) : SV_Target0
{
#if defined(WATER)
    float water = inverse_depth.Load(int3(int2(input.position.xy), 0));
    // Water stands out of its particles into the glass that holds it: by less than this it is not before it.
    float least = water - 2.0 * style.radius_m * water * water;
    bool before = water > 0.0 && input.position.z >= view.near_m * least;
#if defined(BEFORE_WATER)
    if (!before)
        discard;
#else
    if (before)
        discard;
#endif
#endif
    float3 to_eye = normalize(view.eye_m - input.world_m);
    float3 normal = normalize(input.normal);
    normal = dot(normal, to_eye) < 0.0 ? -normal : normal;
    float cosine = dot(normal, to_eye);
    float mirrored = Fresnel(GLASS_F0, cosine);
    float kept = 1.0 - exp(-lerp(FACE_DEPTH, RIM_DEPTH, input.color_rim.w) / max(cosine, 0.12));
    float3 glow = input.color_rim.rgb * (AmbientLight(light, style.floor_color, normal));
    float3 halfway = normalize(light.to_sun + to_eye);
    float3 color = mirrored * Surroundings(light, style, input.world_m, reflect(-to_eye, normal))
        + (1.0 - mirrored) * kept * glow + 0.5 * Power64(saturate(dot(normal, halfway))) * light.sun_color;
    float alpha = mirrored + (1.0 - mirrored) * kept;
    return float4(color / alpha, alpha);
}
