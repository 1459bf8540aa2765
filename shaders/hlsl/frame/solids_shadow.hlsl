// The opaque solids' shadow map, seen along the sun's rays. Depth only.
#pragma vertex SolidsShadowVertex
#pragma fragment SolidsShadowFragment

#include "solid_geometry.hlsli"
#include "environment.hlsli"

StructuredBuffer<uint> solid_indices;
StructuredBuffer<SolidVertex> solid_vertices;
StructuredBuffer<SolidPose> solid_poses;
ConstantBuffer<FrameLight> light;

struct Varyings
{
    float4 position : SV_Position;
};

Varyings SolidsShadowVertex(uint vertex : SV_VertexID)
{
    SolidVertex corner = solid_vertices[solid_indices[vertex]];
    float3 at = ShadowPosition(light, SolidPositionOf(corner, solid_poses[corner.solid]));
    // What stands out of the domain toward the sun shades it all the same.
    at.z = saturate(at.z);
    Varyings output;
    output.position = ClipFromShadow(at);
    return output;
}

void SolidsShadowFragment(Varyings input)
{
}
