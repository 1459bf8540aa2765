// What a body feels of what its solid gave a particle. Sums are integers, so that their order does not matter: of 64 bits,
// the low words by an atomic addition that says whether it carried. Includers declare `body_states`, `reactions` and
// `solids_params`.
#ifndef BROOKLET_REACT
#define BROOKLET_REACT

#include "../solids/layout.hlsli"
#include "layout.hlsli"

void AddToReaction(uint word, float value)
{
    int sum = int(round(clamp(value, -2.0e9, 2.0e9)));
    uint before;
    InterlockedAdd(reactions[word], uint(sum), before);
    uint carry = before + uint(sum) < before ? 1u : 0u;
    uint high = (sum < 0 ? 0xffffffffu : 0u) + carry;
    if (high != 0)
        InterlockedAdd(reactions[word + 1], high, before);
}

// A particle at a position took a change of velocity from a body.
void React(uint body, float3 position_m, float3 taken_m_s)
{
    float3 impulse = -taken_m_s * solids_params.units_per_m_s;
    float3 moment = cross(position_m - body_states[body].position_m, impulse);
    uint word = REACTION_WORDS * body;
    [unroll]
    for (uint axis = 0; axis < 3; ++axis)
    {
        AddToReaction(word + 2 * axis, impulse[axis]);
        AddToReaction(word + 6 + 2 * axis, moment[axis]);
    }
    uint before;
    InterlockedAdd(reactions[word + 12], 1u, before);
}

#endif
