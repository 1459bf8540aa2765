// What parts two particles that are too close. A pair at one point is no compression: its density
// is below rest, nothing would push it, and it would stay one particle for good; the particles of
// a thin sheet would clump.
#ifndef BROOKLET_SEPARATION
#define BROOKLET_SEPARATION

// Closer than this (in h) counts as one point.
static const float COINCIDENT = 1.0e-4;

// What is added to the lambdas of a pair at distance q < separation, both in h: `at_one_point` falls to nothing.
float SeparationLambda(float q, float separation, float at_one_point)
{
    return at_one_point * (1.0 - q / separation);
}

uint HashPair(uint a, uint b)
{
    // PCG's output function (O'Neill 2014) over both indices.
    uint state = (a * 747796405u + b) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

// A vector of length COINCIDENT, in h, from j to i, where the kernel's gradient has no direction:
// drawn from the indices, opposite for the two of them, so that momentum is kept. `along_z` is 0 where
// nothing moves along z.
float3 SeparationOf(uint i, uint j, float along_z)
{
    uint hash = HashPair(min(i, j), max(i, j));
    float3 direction = float3(hash & 1023, (hash >> 10) & 1023, (hash >> 20) & 1023) - 511.5;
    direction.z *= along_z;
    return normalize(direction) * (i < j ? -COINCIDENT : COINCIDENT);
}

#endif
