// The bits of Position::tag. A particle whose state is not finite is quarantined: parked at the domain's corner, at
// rest, in the cell that is nobody's neighbour. An inactive slot keeps its id and holds no particle: it is not moved,
// sorted among others, measured nor drawn.
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

bool IsInactive(uint tag)
{
    return ((tag >> FLUID_SHIFT) & INACTIVE_FLUID) == INACTIVE_FLUID;
}

// Whether the slot holds a particle that takes part.
bool IsSimulated(uint tag)
{
    return !IsQuarantined(tag) && !IsInactive(tag);
}

// By the bits: some drivers compile `x != x` away.
bool IsFinite(float3 v)
{
    uint3 exponent = asuint(v) & 0x7f800000;
    return all(exponent != 0x7f800000);
}

#endif
