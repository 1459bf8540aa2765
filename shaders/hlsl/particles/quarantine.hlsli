// What is done with a particle whose state is not finite (shared/tag.hlsli).
#ifndef BROOKLET_QUARANTINE
#define BROOKLET_QUARANTINE

#include "../shared/layout.hlsli"
#include "../shared/tag.hlsli"

// Parks the particle if a number of it is not finite, where it is if that is known: lists that are kept for a while still have
// it. Says whether it did.
bool QuarantineUnlessFinite(inout Position position, inout Velocity velocity)
{
    if (IsFinite(position.position_m) && IsFinite(velocity.velocity_m_s))
        return false;
    position.tag |= QUARANTINED;
    if (!IsFinite(position.position_m))
        position.position_m = 0.0;
    velocity = (Velocity)0;
    return true;
}

#endif
