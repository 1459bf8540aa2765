// The bits of Position::tag, and what quarantine means: a particle whose state is not finite is
// parked at the domain's corner, at rest, in the cell that is nobody's neighbour.
#ifndef BROOKLET_TAG
#define BROOKLET_TAG

#include "layout.hlsli"

uint IdOf(uint tag)
{
    return tag & ((1u << FLUID_SHIFT) - 1);
}

bool IsQuarantined(uint tag)
{
    return (tag & QUARANTINED) != 0;
}

// By the bits: some drivers compile `x != x` away.
bool IsFinite(float3 v)
{
    uint3 exponent = asuint(v) & 0x7f800000;
    return all(exponent != 0x7f800000);
}

#endif
