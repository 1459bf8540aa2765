// Which particles a drain takes, and what becomes of their slots.
#ifndef BROOKLET_DRAIN
#define BROOKLET_DRAIN

#include "../shared/tag.hlsli"
#include "layout.hlsli"

bool Drains(Drain drain, float3 position_m)
{
    if (drain.shape == DRAIN_SPHERE)
    {
        float3 offset_m = position_m - drain.min_m;
        return dot(offset_m, offset_m) <= drain.max_m.x * drain.max_m.x;
    }
    bool is_inside = all(position_m >= drain.min_m) && all(position_m <= drain.max_m);
    return is_inside != (drain.shape == DRAIN_OUTSIDE);
}

// The next sort, or compaction, puts the slot behind all particles.
void Deactivate(inout Position position, inout Velocity velocity)
{
    position.tag |= INACTIVE_FLUID << FLUID_SHIFT;
    velocity = (Velocity)0;
}

#endif
