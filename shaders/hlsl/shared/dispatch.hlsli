// From group and thread to a linear index; the host folds long dispatches into rows.
#ifndef BROOKLET_DISPATCH
#define BROOKLET_DISPATCH

#include "layout.hlsli"

// Threads of a group where nothing is shared: one wave of every Adreno and of most desktop GPUs.
#define PARTICLE_GROUP 64

// The same fold for a dispatch whose groups the GPU counts.
uint3 FoldGroups(uint groups)
{
    return uint3(min(groups, GROUPS_PER_ROW), (groups + GROUPS_PER_ROW - 1) / GROUPS_PER_ROW, 1);
}

uint LinearGroup(uint3 group)
{
    return group.y * GROUPS_PER_ROW + group.x;
}

uint LinearIndex(uint3 group, uint thread)
{
    return LinearGroup(group) * PARTICLE_GROUP + thread;
}

#endif
