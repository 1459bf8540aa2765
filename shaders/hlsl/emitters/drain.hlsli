// Which particles a drain takes.
#ifndef BROOKLET_DRAIN
#define BROOKLET_DRAIN

#include "../particles/deactivate.hlsli"
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

#endif
