// How much fluid the sun looks through, in spacings, in its parallel projection.
#pragma vertex SunThicknessVertex
#pragma fragment SunThicknessFragment

#include "../shared/layout.hlsl"
#include "layout.hlsl"
#include "../frame/camera.hlsl"
#include "../frame/environment.hlsl"
#include "spread.hlsl"

StructuredBuffer<Position> positions;
ConstantBuffer<FrameLight> light;
ConstantBuffer<SurfaceParams> surface;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
};

Varyings SunThicknessVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Position particle = positions[instance];
    float2 corner = disc_corner(vertex);
    float3 center = shadow_position(light, particle.position_m);
    float radius_uv = surface.spread_m / (light.shadow_texel_m * light.shadow_texels);
    float2 uv = center.xy + corner * radius_uv;
    Varyings output;
    output.position = float4(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y, 0.5, 1.0);
    output.disc = corner;
    if (particle.tag >> 31)
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // quarantined: every corner in one point
    return output;
}

float4 SunThicknessFragment(Varyings input) : SV_Target0
{
    return spread_thickness(input.disc, surface);
}
