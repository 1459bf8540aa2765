// Diffuse particles as optical depth and what is left of their white, both added up: small soft discs before what is opaque. With
// WATER those behind its surface are seen through it: what the water takes of their light it takes of their colour (Beer-Lambert,
// there and back).
//
// One that is smaller than a drawn pixel is drawn as large as that and as much fainter.
#pragma vertex DiffuseVertex
#pragma fragment DiffuseFragment
#pragma multi_compile _ WATER

#include "../frame/camera.hlsli"
#include "layout.hlsli"
#if defined(WATER)
#include "../surface/layout.hlsli"
#endif

StructuredBuffer<DiffuseParticle> diffuse;
#if defined(WATER)
Texture2D<float> inverse_depth;
ConstantBuffer<WaterStyle> water;
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<DiffuseStyle> diffuse_style;

// Spray is finer than what lies on the water.
static const float SPRAY_SIZE = 0.6;
static const float LEAST_PX = 0.7;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
    [[vk::location(1)]] nointerpolation float2 shape : TEXCOORD1;   // optical depth at its middle, distance along the view
};

Varyings DiffuseVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    DiffuseParticle particle = diffuse[instance];
    float3 offset_m = particle.position_m - view.eye_m;
    float4 clip = ClipFromOffset(view, offset_m);
    float2 corner = DiscCorner(vertex);
    float size = lerp(SPRAY_SIZE, 1.0, smoothstep(0.0, SPRAY_BELOW, particle.crowd));
    // A bubble is a shell of light, not a disc of it.
    float depth = diffuse_style.opacity * (particle.crowd > BUBBLE_ABOVE ? 0.35 : 1.0);
    depth *= saturate(particle.lifetime_s / diffuse_style.fade_s);
    float radius_px = diffuse_style.radius_m * size / (max(clip.w, view.near_m) * view.pixel_angle);
    float drawn_px = max(radius_px, LEAST_PX);
    depth *= radius_px * radius_px / (drawn_px * drawn_px);

    Varyings output;
    output.position = clip;
    output.position.xy += corner * drawn_px * 2.0 / view.size_px * clip.w;
    output.disc = corner;
    output.shape = float2(depth, clip.w);
    if (particle.lifetime_s <= 0.0 || clip.w <= 1.5 * view.near_m)
        output.position = float4(0.0, 0.0, 0.0, 1.0);
    return output;
}

float4 DiffuseFragment(Varyings input) : SV_Target0
{
    float inside = saturate(1.0 - dot(input.disc, input.disc));
    float depth = input.shape.x * inside * inside;
    float3 tint = 1.0;
#if defined(WATER)
    float here = inverse_depth.Load(int3(int2(input.position.xy), 0));
    float behind_m = here > 0.0 ? max(input.shape.y - 1.0 / here - diffuse_style.spacing_m, 0.0) : 0.0;
    tint = exp(-2.0 * water.absorption_per_m * behind_m);
    depth *= exp(-water.scatter_per_m * behind_m);
#endif
    return float4(tint * depth, depth);
}
