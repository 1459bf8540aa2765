// How much fluid the sun looks through, in spacings, in its parallel projection.
#pragma vertex SunThicknessVertex
#pragma fragment SunThicknessFragment
#pragma multi_compile _ ELLIPSOID_CENTERS

#include "../shared/tag.hlsli"
#include "../frame/camera.hlsli"
#include "../frame/environment.hlsli"
#include "thickness_kernel.hlsli"

ConstantBuffer<FrameLight> light;
ConstantBuffer<SurfaceParams> surface;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
};

Varyings SunThicknessVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Center center = CenterOf(instance);
    float2 corner = DiscCorner(vertex);
    float radius_uv = surface.thickness_radius_m / (light.shadow_texel_m * light.shadow_texels);
    Varyings output;
    output.position = ClipFromShadow(float3(ShadowPosition(light, center.at_m).xy + corner * radius_uv, 0.5));
    output.disc = corner;
    if (!IsSimulated(center.tag))
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // every corner in one point: nothing is drawn
    return output;
}

float4 SunThicknessFragment(Varyings input) : SV_Target0
{
    return ThicknessKernel(input.disc, surface);
}
