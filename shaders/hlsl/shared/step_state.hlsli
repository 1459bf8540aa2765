// Sets how many slots a substep visits, and what says so to dispatches and draws.
#ifndef BROOKLET_STEP_STATE
#define BROOKLET_STEP_STATE

#include "dispatch.hlsli"

void VisitSlots(inout StepState state, uint slot_count)
{
    state.slot_count = slot_count;
    state.slot_groups = FoldGroups((slot_count + PARTICLE_GROUP - 1) / PARTICLE_GROUP);
    state.vertex_count = 3;
    state.instance_count = slot_count;
    state.first_vertex = 0;
    state.first_instance = 0;
}

#endif
