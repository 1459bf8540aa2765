// The vertex stage of what covers the whole picture and needs nothing but its pixel.
#ifndef BROOKLET_COVERING
#define BROOKLET_COVERING

#include "camera.hlsli"

struct Varyings
{
    float4 position : SV_Position;
};

Varyings Covering(uint vertex)
{
    Varyings output;
    output.position = float4(CoveringCorner(vertex), 0.0, 1.0);
    return output;
}

#endif
