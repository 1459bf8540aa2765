// The sky, wherever nothing else was drawn (depth still 0, infinitely far).
#pragma vertex SkyVertex
#pragma fragment SkyFragment

#include "covering_ray.hlsli"
#include "environment.hlsli"

ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;

Varyings SkyVertex(uint vertex : SV_VertexID)
{
    return CoveringRay(view, vertex);
}

float4 SkyFragment(Varyings input) : SV_Target0
{
    return float4(SkyRadiance(light, normalize(input.ray)), 1.0);
}
