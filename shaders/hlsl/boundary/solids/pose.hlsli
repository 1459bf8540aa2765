// Where a solid's frame is.
#ifndef BROOKLET_POSE
#define BROOKLET_POSE

// A direction, turned by a quaternion (x, y, z, w).
float3 Turned(float4 rotation, float3 direction)
{
    float3 twice = 2.0 * cross(rotation.xyz, direction);
    return direction + rotation.w * twice + cross(rotation.xyz, twice);
}

float4 Inverse(float4 rotation)
{
    return float4(-rotation.xyz, rotation.w);
}

// A place in the solid's frame, of one in the domain's, and back.
float3 InFrame(float3 position_m, float3 frame_m, float4 rotation)
{
    return Turned(Inverse(rotation), position_m - frame_m);
}

float3 FromFrame(float3 place_m, float3 frame_m, float4 rotation)
{
    return frame_m + Turned(rotation, place_m);
}

#endif
