// The surface that sunlight meets: the nearest of all particles' spheres, or ellipsoids, in the sun's
// parallel projection, as shadow depth (1 nearest the sun), in which planes are linear; 0 where no
// fluid is. At the walls they are cut off, as the eye sees them (surface/fluid_depth.hlsl). Drops of
// spray are left out: the map is too coarse for such lenses, which would tear holes into the light below.
#pragma vertex SunDepthVertex
#pragma fragment SunDepthFragment
#pragma multi_compile _ SPRAY_SHAPE ELLIPSOID_SHAPE

#include "../shared/tag.hlsli"
#include "impostor.hlsli"
#include "spray.hlsli"
#include "../frame/environment.hlsli"

#if defined(ELLIPSOID_SHAPE)
StructuredBuffer<Ellipsoid> ellipsoids;
#else
StructuredBuffer<Position> positions;
#endif
#if defined(SPRAY_SHAPE)
StructuredBuffer<ListHead> list_heads;
#endif
ConstantBuffer<FrameLight> light;
ConstantBuffer<SurfaceParams> surface;

// What is smaller is spray, over a particle among others.
static const float LEAST_SIZE = 0.8;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;
    // On the plane of the outline: what the sun sees of an ellipsoid is bounded by a plane curve.
    [[vk::location(1)]] float3 world_m : TEXCOORD1;
    // How far the surface rises above that plane in the middle, along the sun's rays.
    [[vk::location(2)]] nointerpolation float rise_m : TEXCOORD2;
};

Varyings SunDepthVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    float2 corner = DiscCorner(vertex);
    Varyings output;
    output.disc = corner;
#if defined(ELLIPSOID_SHAPE)
    // In the space that the matrix stretches from, the outline is the unit circle across the sun's ray.
    float3x3 stretch = StretchOf(ellipsoids[instance].stretch);
    float3 toward = Unstretched(stretch, light.to_sun);
    float along = length(toward);
    uint tag = ellipsoids[instance].tag;
    // The mean of its axes is at least 1, but that of spray.
    bool is_spray = stretch[0][0] + stretch[1][1] + stretch[2][2] < 3.0 * LEAST_SIZE;
    output.world_m = ellipsoids[instance].center_m + surface.radius_m * mul(stretch, AcrossAxis(toward / along, corner));
    output.rise_m = surface.radius_m / along;
#else
    float radius_m = surface.radius_m;
#if defined(SPRAY_SHAPE)
    bool is_spray = SizeOf(list_heads[instance]) < LEAST_SIZE;
#else
    bool is_spray = false;
#endif
    uint tag = positions[instance].tag;
    output.world_m = positions[instance].position_m + radius_m * AcrossAxis(light.to_sun, corner);
    output.rise_m = radius_m;
#endif
    // At the nearest point, so the depth written is never nearer: hidden ones are rejected early.
    output.position = ClipFromShadow(ShadowPosition(light, output.world_m + output.rise_m * light.to_sun));
    if (!IsSimulated(tag) || is_spray)
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // every corner in one point: nothing is drawn
    return output;
}

struct Surface
{
    float shadow_depth : SV_Target0;
    float depth : SV_DepthLessEqual;
};

Surface SunDepthFragment(Varyings input)
{
    float s = dot(input.disc, input.disc);
    if (s > 1.0)
        discard;
    float rise_m = input.rise_m * sqrt(1.0 - s);
    // The box's slabs (Kay & Kajiya 1986).
    float3 inverse = 1.0 / light.to_sun;
    float3 a = (surface.wall_min_m - input.world_m) * inverse;
    float3 b = (surface.wall_max_m - input.world_m) * inverse;
    float3 low = min(a, b);
    float3 high = max(a, b);
    float along_m = min(rise_m, min(high.x, min(high.y, high.z)));
    if (along_m < max(-rise_m, max(low.x, max(low.y, low.z))))
        discard;
    Surface output;
    output.shadow_depth = ShadowPosition(light, input.world_m + along_m * light.to_sun).z;
    output.depth = output.shadow_depth;
    return output;
}
