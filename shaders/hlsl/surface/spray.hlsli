// How large a particle is drawn that is not stretched: one far from all others is a drop of spray, and
// as large as one that has to meet its neighbours it would be a ball of glass.
#ifndef BROOKLET_SPRAY
#define BROOKLET_SPRAY

#include "../shared/layout.hlsli"
#include "layout.hlsli"

static const float SPRAY_NEIGHBOURS = 14.0; // about those of a flat surface at h = 2 d

// Over a particle among others. Lists that no step has made yet are all zero: what is not known to be
// spray is drawn in full. (So is a particle alone whose cell is the grid's first: its list begins at
// 0, too.)
float SizeOf(ListHead list)
{
    float crowd = smoothstep(1.0, SPRAY_NEIGHBOURS, float(list.entries));
    return (list.entries | list.first) == 0 ? 1.0 : lerp(SPRAY_RADIUS, 1.0, crowd);
}

#endif
