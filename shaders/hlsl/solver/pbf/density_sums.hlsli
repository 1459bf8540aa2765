// What a particle's neighbours add up to in its density constraint, and the lambda that follows
// (Macklin & Muller 2013, eq. 8-11), with lengths in units of h and the density as its ratio to the
// rest density. Only compression is a violation: a free surface does not pull.
#ifndef BROOKLET_DENSITY_SUMS
#define BROOKLET_DENSITY_SUMS

#include "../../shared/quantized_position.hlsli"
#include "../../shared/wendland.hlsli"

struct DensitySums
{
    float density;
    float3 gradient;            // of the constraint, over the particle's own position
    float gradient_squares;     // over its neighbours' positions; both in units of a pair until they are Weighted
};

// Of a particle alone: W(0) = 1.
DensitySums NoNeighbours()
{
    DensitySums sums;
    sums.density = 1.0;
    sums.gradient = 0.0;
    sums.gradient_squares = 0.0;
    return sums;
}

// `is_other`: not the particle itself, whose distance of 0 has no gradient but a density.
void AddNeighbour(inout DensitySums sums, PairCoordinates x_i, PairCoordinates x_j, bool is_other)
{
    float3 offset = PairOffset(x_i, x_j);
    float squared = dot(offset, offset);
    WendlandPair pair = WendlandOf(sqrt(squared), SUPPORTS_PER_UNIT);
    sums.density += is_other ? WendlandW(pair) : 0.0;
    sums.gradient += pair.t_cubed * offset;
    sums.gradient_squares += pair.t_cubed * pair.t_cubed * squared;
}

DensitySums Weighted(DensitySums sums, float weight)
{
    float unit = weight * (WENDLAND_GRADIENT * SUPPORTS_PER_UNIT);
    sums.density *= weight;
    sums.gradient *= unit;
    sums.gradient_squares *= unit * unit;
    return sums;
}

// The denominator of lambda. Without neighbours and without mixing there would be nothing to divide by.
float Stiffness(DensitySums sums, float cfm)
{
    return max(dot(sums.gradient, sums.gradient) + sums.gradient_squares + cfm, 1.0e-6);
}

float DensityLambda(DensitySums sums, float cfm)
{
    float constraint = max(sums.density - 1.0, 0.0);
    return constraint > 0.0 ? -constraint / Stiffness(sums, cfm) : 0.0;
}

#endif
