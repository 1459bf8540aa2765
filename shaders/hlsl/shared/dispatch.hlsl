// From group and thread to a linear index. Vulkan promises 65,535 groups an axis only, so the
// host folds longer dispatches into rows of GROUPS_A_ROW (its twin: gpu/recording).
#ifndef BROOKLET_DISPATCH
#define BROOKLET_DISPATCH

static const uint GROUPS_A_ROW = 32768;

// Threads of a group where nothing is shared: one wave of every Adreno and of most desktop GPUs.
#define PARTICLE_GROUP 64

uint LinearGroup(uint3 group)
{
    return group.y * GROUPS_A_ROW + group.x;
}

uint LinearIndex(uint3 group, uint thread)
{
    return LinearGroup(group) * PARTICLE_GROUP + thread;
}

#endif
