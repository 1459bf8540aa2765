// The surface's mesh as the eye sees it: inverse depth, and the normal that the field gave each vertex. What lies in a
// wall has the wall's, so that the water's edge at the glass is sharp though its vertices have one normal each.
#pragma vertex MeshDepthVertex
#pragma fragment MeshDepthFragment

#include "../../shared/layout.hlsli"
#include "../../frame/camera.hlsli"
#include "layout.hlsli"

StructuredBuffer<uint> mesh_indices;
StructuredBuffer<MeshVertex> mesh_vertices;
ConstantBuffer<FrameView> view;
ConstantBuffer<MeshParams> mesh;

// As near to a wall as f32 places what lies in it, over a cell's side.
#define IN_WALL 1e-3

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float3 offset_m : TEXCOORD0;
    [[vk::location(1)]] float3 normal : TEXCOORD1;
};

Varyings MeshDepthVertex(uint vertex : SV_VertexID)
{
    MeshVertex corner = mesh_vertices[mesh_indices[vertex]];
    Varyings output;
    output.offset_m = corner.position_m - view.eye_m;
    output.position = ClipFromOffset(view, output.offset_m);
    output.normal = corner.normal;
    return output;
}

struct Surface
{
    float inverse_depth_per_m : SV_Target0;
    float4 normal : SV_Target1;     // toward the eye, alpha 1
};

// Interpolated, a normal may look away from the eye where its triangle does not: along outlines, and all over a drop of a
// few cells. The water would mirror what is below the horizon there. It is turned until it faces the eye half as much as the
// triangle does.
float3 TowardEye(float3 normal, float3 offset_m)
{
    float3 to_eye = -normalize(offset_m);
    float3 triangle_normal = normalize(cross(ddx(offset_m), ddy(offset_m)));
    float least = 0.5 * abs(dot(triangle_normal, to_eye));
    float facing = dot(normal, to_eye);
    if (!(facing < least))
        return normal;
    float3 aside = normal - facing * to_eye;
    return least * to_eye + sqrt(1.0 - least * least) * normalize(aside + 1e-6 * view.up);
}

Surface MeshDepthFragment(Varyings input)
{
    Surface surface;
    surface.inverse_depth_per_m = 1.0 / dot(input.offset_m, view.forward);
    float3 normal = normalize(input.normal);
    float3 position_m = view.eye_m + input.offset_m;
    float3 low = step(abs(position_m - mesh.wall_min_m), IN_WALL * mesh.cell_m);
    float3 high = step(abs(position_m - mesh.wall_max_m), IN_WALL * mesh.cell_m);
    if (any(low + high > 0.0))
        normal = normalize(high - low);
    surface.normal = float4(TowardEye(normal, input.offset_m), 1.0);
    return surface;
}
