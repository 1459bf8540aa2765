// The speed that no particle exceeds. Includers declare `step_params` and `counters`.
#ifndef BROOKLET_SLOWED
#define BROOKLET_SLOWED

// Who was slowed is above the limit by three roundings at most, and is not slowed and counted again by who comes next.
static const float ALREADY_SLOWED = 1.0 + 4.0e-7;

// The velocity, no faster than allowed; counts whom it slows.
float3 Slowed(float3 velocity_m_s)
{
    float speed_m_s = length(velocity_m_s);
    if (speed_m_s > ALREADY_SLOWED * step_params.max_speed_m_s)
    {
        // Above 1.8e19 m/s the length itself overflows; the particle then stops, finite.
        velocity_m_s *= step_params.max_speed_m_s / speed_m_s;
        uint before;
        InterlockedAdd(counters[0].speed_clamps, 1u, before);
    }
    return velocity_m_s;
}

#endif
