// The vertex stage of what covers the whole picture and looks through each of its pixels.
#ifndef BROOKLET_COVERING_RAY
#define BROOKLET_COVERING_RAY

#include "camera.hlsli"

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float3 ray : TEXCOORD0;     // length 1 along `forward`
};

Varyings CoveringRay(FrameView view, uint vertex)
{
    float2 corner = CoveringCorner(vertex);
    Varyings output;
    output.position = float4(corner, 0.0, 1.0);
    output.ray = RayThrough(view, corner);
    return output;
}

#endif
