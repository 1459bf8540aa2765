// One picture over another, as far as its opacity: while the surface goes from one method to the other.
#pragma vertex CrossFadeVertex
#pragma fragment CrossFadeFragment

#include "camera.hlsli"

Texture2D<float4> picture;
ConstantBuffer<CrossFadeParams> cross_fade;

struct Varyings
{
    float4 position : SV_Position;
};

Varyings CrossFadeVertex(uint vertex : SV_VertexID)
{
    Varyings output;
    output.position = float4(CoveringCorner(vertex), 0.0, 1.0);
    return output;
}

float4 CrossFadeFragment(Varyings input) : SV_Target0
{
    return float4(picture.Load(int3(int2(input.position.xy), 0)).rgb, cross_fade.opacity);
}
