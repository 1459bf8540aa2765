// Sets how many slots a substep visits, and what says so to dispatches and draws.
#ifndef BROOKLET_STEP_STATE
#define BROOKLET_STEP_STATE

#include "dispatch.hlsli"

void VisitSlots(inout StepState state, uint slot_count)
{
    uint groups = (slot_count + PARTICLE_GROUP - 1) / PARTICLE_GROUP;
    state.slot_count = slot_count;
    state.slot_groups = uint3(min(groups, GROUPS_PER_ROW), (groups + GROUPS_PER_ROW - 1) / GROUPS_PER_ROW, 1);
    state.vertex_count = 3;
    state.instance_count = slot_count;
    state.first_vertex = 0;
    state.first_instance = 0;
}

#endif
