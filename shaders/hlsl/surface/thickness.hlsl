// How much fluid each pixel looks through, in spacings: every particle spreads its volume d^3 over a
// disc, and the discs add up. What overlapping spheres count twice a volume does not.
//
// What is opaque hides the water behind it: only particles before the plane that touches it in the pixel
// count. The plane and not its depth there, as a floor that is seen from low down is met far in front
// of particles that lie on it and are seen over it.
#pragma vertex ThicknessVertex
#pragma fragment ThicknessFragment
#pragma multi_compile _ ELLIPSOID_CENTERS

#include "impostor.hlsli"
#include "thickness_kernel.hlsli"

ConstantBuffer<FrameView> view;
ConstantBuffer<SurfaceParams> surface;
Texture2D<float4> opaque_planes;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
    // Of the particle, relative to the eye.
    [[vk::location(1)]] nointerpolation float3 center_m : TEXCOORD1;
};

Varyings ThicknessVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Center center = CenterOf(instance);
    float2 corner = DiscCorner(vertex);
    Impostor impostor = ImpostorOf(view, center.at_m, center.tag, surface.thickness_radius_m, corner);
    Varyings output;
    output.position = ClipFromOffset(view, impostor.ray * impostor.distance_m);
    output.disc = corner;
    output.center_m = center.at_m - view.eye_m;
    if (!impostor.drawn)
        output.position = float4(0.0, 0.0, 0.0, 1.0);
    return output;
}

float4 ThicknessFragment(Varyings input) : SV_Target0
{
    float4 plane = opaque_planes.Load(int3(int2(input.position.xy), 0));
    // Particles stay outside of what is opaque: one whose center lies on it is all before it. Those behind fade
    // within half a spacing, so that nothing pops.
    float before = smoothstep(-1.0, 0.0, plane.w - dot(plane.xyz, input.center_m));
    return ThicknessKernel(input.disc, surface) * before;
}
