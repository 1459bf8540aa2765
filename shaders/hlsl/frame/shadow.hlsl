// The shadow map: each particle as a disc, seen along the sun's rays. Depth only.
#pragma vertex ShadowVertex
#pragma fragment ShadowFragment

#include "../shared/layout.hlsli"
#include "../shared/tag.hlsli"
#include "camera.hlsli"
#include "environment.hlsli"

StructuredBuffer<Position> positions;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
};

Varyings ShadowVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Position particle = positions[instance];
    float2 corner = DiscCorner(vertex);
    float3 center = ShadowPosition(light, particle.position_m);
    float radius_uv = style.radius_m / (light.shadow_texel_m * light.shadow_texels);
    // The particle's front, so that the half facing the sun does not shade itself.
    float depth = center.z + style.radius_m / light.shadow_range_m;

    Varyings output;
    output.position = ClipFromShadow(float3(center.xy + corner * radius_uv, depth));
    output.disc = corner;
    if (!IsSimulated(particle.tag))
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // every corner in one point: nothing is drawn
    return output;
}

void ShadowFragment(Varyings input)
{
    if (dot(input.disc, input.disc) > 1.0)
        discard;
}
