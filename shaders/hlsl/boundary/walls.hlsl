// What the domain's walls add to a particle's density ratio: Harada, Koshizuka & Kawaguchi 2007's
// wall-weight function, precomputed over the distances to the nearest wall along each axis, so
// that edges and corners count what lies beyond two or three walls once (host: boundary/walls).
// Without it particles see a void beyond a wall and pile up there.
#ifndef BROOKLET_WALLS
#define BROOKLET_WALLS

#include "../shared/layout.hlsl"

// xyz: gradient over the three distances, 1/h; w: density ratio.
StructuredBuffer<float4> wall_weights;

float4 WallNode(uint3 node)
{
    return wall_weights[(node.z * WALL_NODES + node.y) * WALL_NODES + node.x];
}

// At distances (in h) to one wall an axis; 1 or more: no wall there.
float4 WallWeight(float3 distances)
{
    float3 place = saturate(distances) * (WALL_NODES - 1);
    uint3 low = min(uint3(place), WALL_NODES - 2);
    float3 part = place - float3(low);
    float4 x00 = lerp(WallNode(low), WallNode(low + uint3(1, 0, 0)), part.x);
    float4 x10 = lerp(WallNode(low + uint3(0, 1, 0)), WallNode(low + uint3(1, 1, 0)), part.x);
    float4 x01 = lerp(WallNode(low + uint3(0, 0, 1)), WallNode(low + uint3(1, 0, 1)), part.x);
    float4 x11 = lerp(WallNode(low + uint3(0, 1, 1)), WallNode(low + uint3(1, 1, 1)), part.x);
    return lerp(lerp(x00, x10, part.y), lerp(x01, x11, part.y), part.z);
}

// Density ratio (w) and its gradient in the domain's axes (xyz, 1/h) at a position.
float4 WallsAt(float3 position_m, float3 domain_size_m, float inverse_support_per_m)
{
    float3 low = position_m * inverse_support_per_m;
    float3 high = (domain_size_m - position_m) * inverse_support_per_m;
#if defined(NARROW_WALLS)
    // Opposite walls within reach of one particle. What lies beyond them is disjoint, so along
    // such an axis the union of all is (low wall) + (high wall) - (neither).
    float4 sum = 0.0;
    for (uint choice = 0; choice < 27; ++choice)
    {
        uint3 pick = uint3(choice, choice / 3, choice / 9) % 3; // 0 low wall, 1 high wall, 2 none
        float sign_of_term = 1.0;
        float3 distances;
        float3 direction;
        [unroll]
        for (uint axis = 0; axis < 3; ++axis)
        {
            distances[axis] = pick[axis] == 0 ? low[axis] : (pick[axis] == 1 ? high[axis] : 1.0);
            direction[axis] = pick[axis] == 0 ? 1.0 : (pick[axis] == 1 ? -1.0 : 0.0);
            sign_of_term *= pick[axis] == 2 ? -1.0 : 1.0;
        }
        float4 weight = WallWeight(distances);
        sum += sign_of_term * float4(weight.xyz * direction, weight.w);
    }
    return sum;
#else
    bool3 nearer_low = low < high;
    float3 distances = min(low, high);
    if (all(distances >= 1.0))
        return 0.0;
    float4 weight = WallWeight(distances);
    float3 direction = float3(nearer_low.x ? 1.0 : -1.0, nearer_low.y ? 1.0 : -1.0, nearer_low.z ? 1.0 : -1.0);
    return float4(weight.xyz * direction, weight.w);
#endif
}

// The density ratio beyond one wall alone, at a distance in h.
float WallPlaneWeight(float distance)
{
    float place = saturate(distance) * (WALL_NODES - 1);
    uint low = min(uint(place), WALL_NODES - 2);
    uint far = WALL_NODES - 1;
    return lerp(WallNode(uint3(low, far, far)).w, WallNode(uint3(low + 1, far, far)).w, place - float(low));
}

// How much of a correction along each axis the fluid's own neighbours give near walls along the
// others, inverted. Behind a wall the fluid's mirror image would push along the wall as well, in
// proportion to the kernel that lies there: the integral of -y dW/dy beyond the wall is that of W.
// Without it the layer at a wall feels too little of the pressure's slope along the wall, sinks,
// and stirs water that should rest.
float3 AlongWalls(float3 position_m, float3 domain_size_m, float inverse_support_per_m)
{
    float3 low = position_m * inverse_support_per_m;
    float3 high = (domain_size_m - position_m) * inverse_support_per_m;
    float3 left;
    [unroll]
    for (uint axis = 0; axis < 3; ++axis)
        left[axis] = 1.0 - min(WallPlaneWeight(low[axis]) + WallPlaneWeight(high[axis]), 0.5);
    return 1.0 / (left.yzx * left.zxy);
}

#endif
