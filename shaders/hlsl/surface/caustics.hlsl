// The light that photons bring to the floor, in the sun's map: 1 where the sun shines on it unhindered.
//
// Each photon's light is a tent over the parallelogram that it and its neighbours make where they land (photon
// differentials: Igehy 1999, Schjoth et al. 2007), so its flux is its own however it is spread.
// Tents of an affine grid add up to one everywhere: calm water lights the floor evenly, without
// noise at any number of photons, and where rays meet the tents narrow to bright lines.
#pragma vertex CausticsVertex
#pragma fragment CausticsFragment

#include "sun_map.hlsli"
#include "../frame/camera.hlsli"

StructuredBuffer<Photon> photons;
ConstantBuffer<FrameLight> light;
ConstantBuffer<SurfaceParams> surface;
ConstantBuffer<WaterStyle> water;

// Neighbours that land more cells apart came through another surface, or light is torn apart: a tent is no
// longer than so many.
static const float MOST_APART = 4.0;
// A tent is no narrower than so many texels of the map, or texels would miss it.
static const float LEAST_TEXELS = 1.0;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 tent : TEXCOORD0;
    [[vk::location(1)]] nointerpolation float3 light : TEXCOORD1;
};

// How far apart photons land along a direction of the grid: the mean of both sides, or the shorter one where
// the longer leads to another surface; the grid's own spacing where no neighbour met water.
float2 LandedApart(int2 at, int2 along, Photon here, float2 unbent)
{
    int side = int(surface.photons);
    int step = along.x + along.y * side;
    int index = at.x + at.y * side;
    int index_along = dot(at, along);
    Photon before = photons[index_along > 0 ? index - step : index];
    Photon after = photons[index_along + 1 < side ? index + step : index];
    float2 backward = here.uv - before.uv;
    float2 forward = after.uv - here.uv;
    bool has_before = index_along > 0 && before.share > 0.0;
    bool has_after = index_along + 1 < side && after.share > 0.0;
    float most = MOST_APART / surface.photons;
    float2 apart = unbent;
    if (has_before && has_after && max(length(backward), length(forward)) < most)
        apart = 0.5 * (backward + forward);
    else if (has_before && (!has_after || length(backward) < length(forward)))
        apart = backward;
    else if (has_after)
        apart = forward;
    return apart * min(1.0, most / max(length(apart), 1e-20));
}

Varyings CausticsVertex(uint vertex : SV_VertexID)
{
    uint index = vertex / 6;
    uint side = uint(surface.photons);
    int2 at = int2(int(index % side), int(index / side));
    Photon photon = photons[index];
    float spacing = 1.0 / surface.photons;
    float2 along_u = LandedApart(at, int2(1, 0), photon, float2(spacing, 0.0));
    float2 along_v = LandedApart(at, int2(0, 1), photon, float2(0.0, spacing));
    // As wide as the map can show, across as along: where rays meet, a parallelogram is a line.
    float least = LEAST_TEXELS / light.shadow_texels;
    float u_length = length(along_u);
    float2 axis = u_length > 0.0 ? along_u / u_length : float2(1.0, 0.0);
    along_u = axis * max(u_length, least);
    float2 across = float2(-axis.y, axis.x);
    float height = dot(along_v, across);
    along_v = dot(along_v, axis) * axis + (height < 0.0 ? -1.0 : 1.0) * max(abs(height), least) * across;
    float area = max(u_length, least) * max(abs(height), least);

    float2 corner = QuadCorner(vertex % 6);
    Varyings output;
    output.position = ClipFromShadow(float3(photon.uv + corner.x * along_u + corner.y * along_v, 0.5));
    output.tent = corner;
    output.light = photon.share * spacing * spacing / area * exp(-water.absorption_per_m * photon.path_m);
    if (photon.share <= 0.0)
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // no water: every corner in one point
    return output;
}

float4 CausticsFragment(Varyings input) : SV_Target0
{
    float2 tent = saturate(1.0 - abs(input.tent));
    return float4(tent.x * tent.y * input.light, 1.0);
}
