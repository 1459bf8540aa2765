// How much fluid each pixel looks through, in spacings: every particle spreads its volume d^3 over a
// disc, and the discs add up. What overlapping spheres count twice a volume does not.
#pragma vertex ThicknessVertex
#pragma fragment ThicknessFragment
#pragma multi_compile _ ELLIPSOID_CENTERS

#include "impostor.hlsli"
#include "thickness_kernel.hlsli"

ConstantBuffer<FrameView> view;
ConstantBuffer<SurfaceParams> surface;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
};

Varyings ThicknessVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Center center = CenterOf(instance);
    float2 corner = DiscCorner(vertex);
    Impostor impostor = ImpostorOf(view, center.at_m, center.tag, surface.thickness_radius_m, corner);
    Varyings output;
    output.position = ClipFromOffset(view, impostor.ray * impostor.distance_m);
    output.disc = corner;
    if (!impostor.drawn)
        output.position = float4(0.0, 0.0, 0.0, 1.0);
    return output;
}

float4 ThicknessFragment(Varyings input) : SV_Target0
{
    return ThicknessKernel(input.disc, surface);
}
