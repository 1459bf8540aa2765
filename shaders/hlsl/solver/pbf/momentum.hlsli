// Lambda with momentum: Chebyshev's semi-iteration (Golub & Varga 1961; Wang 2015) on the density constraint. Weights
// of an iteration come from the host (fluid/src/solver/pbf/chebyshev.rs). Pairs still take the sum of their
// particles' lambdas, so momentum of the fluid is kept.
#ifndef BROOKLET_MOMENTUM
#define BROOKLET_MOMENTUM

#include "density_sums.hlsli"

// Compression above which steps become shorter, and from which on an iteration is plain Jacobi: the bound on the
// spectrum that the weights are made for grows with density.
static const float GUARD_BEGIN = 0.04;
static const float GUARD_END = 0.08;

// What an iteration adds to a particle's multiplier, `before` being what the one before added. Not only compression
// counts: what is below rest density takes back.
float LambdaStep(DensitySums sums, float cfm, PbfIteration iteration, float before)
{
    float excess = sums.density - 1.0;
    float ratio = excess / Stiffness(sums, cfm);
    float lambda = iteration.momentum * before - iteration.step * ratio;
    float guard = saturate((excess - GUARD_BEGIN) / (GUARD_END - GUARD_BEGIN));
    return lambda + guard * (-iteration.guarded_step * ratio - lambda);
}

// Momentum ends where nothing is compressed.
float MomentumLambda(DensitySums sums, float cfm, PbfIteration iteration, float before)
{
    return sums.density > 1.0 ? LambdaStep(sums, cfm, iteration, before) : 0.0;
}

// Of a particle whose multiplier, the sum of its lambdas, was `total`: it never pulls in the end, but gives back what
// was too much. With many iterations that halves the largest compressions, and injects no energy.
float AccumulatedLambda(DensitySums sums, float cfm, PbfIteration iteration, float before, float total)
{
    return min(total + LambdaStep(sums, cfm, iteration, before), 0.0) - total;
}

#endif
