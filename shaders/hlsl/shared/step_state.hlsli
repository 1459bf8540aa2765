// Sets how many slots a substep visits, and what says so to dispatches and draws.
#ifndef BROOKLET_STEP_STATE
#define BROOKLET_STEP_STATE

#include "dispatch.hlsli"

// A substep of so long begins. Compensated (Kahan 1965): of 10^6 equal steps a plain f32 sum loses more than a hundredth.
void AdvanceTime(inout StepState state, float dt_s)
{
    state.dt_s = dt_s;
    precise float step_s = dt_s - state.time_lost_s;
    precise float time_s = state.time_s + step_s;
    precise float gained_s = time_s - state.time_s;
    precise float lost_s = gained_s - step_s;
    state.time_lost_s = lost_s;
    state.time_s = time_s;
}

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
