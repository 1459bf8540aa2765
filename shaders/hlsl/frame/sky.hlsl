// The sky, wherever nothing else was drawn (depth still 0, infinitely far).
#pragma vertex SkyVertex
#pragma fragment SkyFragment

#include "camera.hlsli"
#include "environment.hlsli"

ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float3 ray : TEXCOORD0;
};

Varyings SkyVertex(uint vertex : SV_VertexID)
{
    float2 corner = CoveringCorner(vertex);
    Varyings output;
    output.position = float4(corner, 0.0, 1.0);
    output.ray = RayThrough(view, corner);
    return output;
}

float4 SkyFragment(Varyings input) : SV_Target0
{
    return float4(SkyRadiance(light, normalize(input.ray)), 1.0);
}
