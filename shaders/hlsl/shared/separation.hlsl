// A direction for two particles at one point, where the kernel's gradient has none: drawn from
// their indices, opposite for the two of them, so that momentum is kept.
#ifndef BROOKLET_SEPARATION
#define BROOKLET_SEPARATION

// Closer than this (in h) counts as one point.
static const float COINCIDENT = 1.0e-4;

uint HashPair(uint a, uint b)
{
    // PCG's output function (O'Neill 2014) over both indices.
    uint state = (a * 747796405u + b) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

// A vector of length COINCIDENT, in h, from j to i.
float3 SeparationOf(uint i, uint j)
{
    uint hash = HashPair(min(i, j), max(i, j));
    float3 direction = float3(hash & 1023, (hash >> 10) & 1023, (hash >> 20) & 1023) - 511.5;
    return normalize(direction) * (i < j ? -COINCIDENT : COINCIDENT);
}

#endif
