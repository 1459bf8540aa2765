// The velocity of what of a body is at a place.
#ifndef BROOKLET_BODY_VELOCITY
#define BROOKLET_BODY_VELOCITY

#include "layout.hlsli"

float3 VelocityAt(BodyState state, float3 at_m)
{
    return state.velocity_m_s + cross(state.spin_rad_s, at_m - state.position_m);
}

#endif
