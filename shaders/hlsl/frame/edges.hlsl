// The domain's twelve edges as thin lines, as wide on the screen far as near, smooth at their sides.
// With water they are drawn twice: what lies behind it before it, to be refracted, and what lies
// in front over it.
#pragma vertex EdgesVertex
#pragma fragment EdgesFragment
#pragma multi_compile _ BEHIND_WATER BEFORE_WATER

#include "camera.hlsli"

#if defined(BEHIND_WATER) || defined(BEFORE_WATER)
#define WATER
Texture2D<float> inverse_depth;
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameStyle> style;

struct Varyings
{
    float4 position : SV_Position;
    // Linear on the screen, not in depth: the line's side is a matter of pixels.
    [[vk::location(0)]] noperspective float across_px : TEXCOORD0;
    [[vk::location(1)]] float opacity : TEXCOORD1;
};

// Lowest corner and direction of edge 0..11: four along each axis.
void EdgeEnds(uint edge, out float3 from_m, out float3 to_m)
{
    uint axis = edge / 4;
    float a = float(edge & 1);
    float b = float((edge >> 1) & 1);
    float3 low = axis == 0 ? float3(0.0, a, b) : (axis == 1 ? float3(a, 0.0, b) : float3(a, b, 0.0));
    float3 high = low + (axis == 0 ? float3(1.0, 0.0, 0.0) : (axis == 1 ? float3(0.0, 1.0, 0.0) : float3(0.0, 0.0, 1.0)));
    from_m = low * style.domain_size_m - view.eye_m;
    to_m = high * style.domain_size_m - view.eye_m;
}

Varyings EdgesVertex(uint vertex : SV_VertexID, uint edge : SV_InstanceID)
{
    float3 from_m, to_m;
    EdgeEnds(edge, from_m, to_m);
    // What lies behind the camera would be mirrored by the division: cut the line at the near plane.
    float from_z = dot(from_m, view.forward);
    float to_z = dot(to_m, view.forward);
    float nearest = 1.001 * view.near_m;
    float3 clipped_from = from_z < nearest ? lerp(from_m, to_m, (nearest - from_z) / (to_z - from_z)) : from_m;
    float3 clipped_to = to_z < nearest ? lerp(to_m, from_m, (nearest - to_z) / (from_z - to_z)) : to_m;
    float4 a = ClipFromOffset(view, clipped_from);
    float4 b = ClipFromOffset(view, clipped_to);
    float2 a_px = 0.5 * view.size_px * a.xy / a.w;
    float2 b_px = 0.5 * view.size_px * b.xy / b.w;
    float2 along = b_px - a_px;
    along /= max(length(along), 1e-3);
    float2 aside = float2(-along.y, along.x);

    float2 corner = QuadCorner(vertex);
    float half_px = 0.5 * style.edge_width_px * view.supersample + 1.0;
    float4 clip = corner.x < 0.0 ? a : b;
    clip.xy += (corner.y * aside * half_px + corner.x * along * 0.5) * 2.0 / view.size_px * clip.w;
    // A hair nearer, so that the floor does not cut the lines that lie in it.
    clip.z *= 1.002;

    Varyings output;
    output.across_px = corner.y * half_px;
    output.opacity = style.edge_opacity;
    output.position = clip;
    if (from_z < nearest && to_z < nearest)
        output.position = float4(0.0, 0.0, 0.0, 1.0);
    return output;
}

float4 EdgesFragment(Varyings input) : SV_Target0
{
#if defined(WATER)
    float water = inverse_depth.Load(int3(int2(input.position.xy), 0));
    // Reversed depth is near / distance. Edges lie in the walls: a hair in favour of being seen.
    bool before = water > 0.0 && input.position.z >= 0.998 * view.near_m * water;
#if defined(BEFORE_WATER)
    if (!before)
        discard;
#else
    if (before)
        discard;
#endif
#endif
    float half_px = 0.5 * style.edge_width_px * view.supersample;
    float coverage = saturate(half_px + 0.5 - abs(input.across_px));
    float alpha = coverage * input.opacity;
    return float4(style.edge_color, alpha);
}
