// One picture over another, as far as its opacity: while the surface goes from one method to the other.
#pragma vertex CrossFadeVertex
#pragma fragment CrossFadeFragment

#include "covering.hlsli"

Texture2D<float4> picture;
ConstantBuffer<CrossFadeParams> cross_fade;

Varyings CrossFadeVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

float4 CrossFadeFragment(Varyings input) : SV_Target0
{
    return float4(picture.Load(int3(int2(input.position.xy), 0)).rgb, cross_fade.opacity);
}
