// Adding up MeasureSums, over two of them and over a group of PARTICLE_GROUP threads.
#ifndef BROOKLET_SUMS
#define BROOKLET_SUMS

#include "../shared/layout.hlsli"
#include "../shared/dispatch.hlsli"

groupshared MeasureSums shared_measures[PARTICLE_GROUP];

MeasureSums NoMeasure()
{
    MeasureSums none = (MeasureSums)0;
    none.front_m = -3.0e38;
    return none;
}

MeasureSums SumOf(MeasureSums a, MeasureSums b)
{
    MeasureSums sum;
    sum.density_error_sum = a.density_error_sum + b.density_error_sum;
    sum.density_error_max = max(a.density_error_max, b.density_error_max);
    sum.compression_sum = a.compression_sum + b.compression_sum;
    sum.compression_max = max(a.compression_max, b.compression_max);
    sum.position_sum_m = a.position_sum_m + b.position_sum_m;
    sum.front_m = max(a.front_m, b.front_m);
    sum.velocity_sum_m_s = a.velocity_sum_m_s + b.velocity_sum_m_s;
    sum.speed_max_m_s = max(a.speed_max_m_s, b.speed_max_m_s);
    sum.speed_squared_sum_m2_s2 = a.speed_squared_sum_m2_s2 + b.speed_squared_sum_m2_s2;
    sum.particles = a.particles + b.particles;
    sum.quarantined = a.quarantined + b.quarantined;
    sum.escaped = a.escaped + b.escaped;
    return sum;
}

// The sum over the group, in every thread.
MeasureSums SumOfGroup(MeasureSums mine, uint thread)
{
    shared_measures[thread] = mine;
    GroupMemoryBarrierWithGroupSync();
    // Not unrolled: a processor's driver takes seconds to build a kernel that is this long between barriers.
    [loop]
    for (uint half = PARTICLE_GROUP / 2; half > 0; half /= 2)
    {
        if (thread < half)
            shared_measures[thread] = SumOf(shared_measures[thread], shared_measures[thread + half]);
        GroupMemoryBarrierWithGroupSync();
    }
    return shared_measures[0];
}

#endif
