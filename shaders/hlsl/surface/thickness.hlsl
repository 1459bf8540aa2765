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
#include "opaque_plane.hlsli"

Texture2D<float> scene_depth;
ConstantBuffer<FrameView> view;
ConstantBuffer<SurfaceParams> surface;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
    // Clip position without depth: where in the scene's own, larger picture this is.
    [[vk::location(1)]] float3 clip : TEXCOORD1;
    // Of the particle, relative to the eye.
    [[vk::location(2)]] nointerpolation float3 center_m : TEXCOORD2;
};

Varyings ThicknessVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Center center = CenterOf(instance);
    float2 corner = DiscCorner(vertex);
    Impostor impostor = ImpostorOf(view, center.at_m, center.tag, surface.thickness_radius_m, corner);
    Varyings output;
    output.position = ClipFromOffset(view, impostor.ray * impostor.distance_m);
    output.disc = corner;
    output.clip = output.position.xyw;
    output.center_m = center.at_m - view.eye_m;
    if (!impostor.drawn)
        output.position = float4(0.0, 0.0, 0.0, 1.0);
    return output;
}

float4 ThicknessFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2((float2(0.5, -0.5) * input.clip.xy / input.clip.z + 0.5) * view.size_px);
    float3 plane = OpaquePlaneAt(scene_depth, view, pixel, surface.range_m);
    return ThicknessKernel(input.disc, surface) * ShareBefore(plane, input.center_m, 0.5 * surface.spacing_m);
}
