// An empty slot. The next sort, or compaction, puts it behind all particles, where it can be filled.
#ifndef BROOKLET_DEACTIVATE
#define BROOKLET_DEACTIVATE

#include "../shared/tag.hlsli"

void Deactivate(inout Position position, inout Velocity velocity)
{
    position.tag |= INACTIVE_FLUID << FLUID_SHIFT;
    velocity = (Velocity)0;
}

#endif
