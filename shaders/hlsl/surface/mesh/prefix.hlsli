// Sums before each thread of a group of 64.
#ifndef BROOKLET_MESH_PREFIX
#define BROOKLET_MESH_PREFIX

groupshared uint shared_sums[2][64];

// The sum of `count` over the threads before this one (Hillis & Steele 1986).
uint PrefixOf(uint count, uint thread)
{
    uint from = 0;
    shared_sums[0][thread] = count;
    GroupMemoryBarrierWithGroupSync();
    [unroll]
    for (uint reach = 1; reach < 64; reach *= 2)
    {
        uint sum = shared_sums[from][thread];
        if (thread >= reach)
            sum += shared_sums[from][thread - reach];
        from = 1 - from;
        shared_sums[from][thread] = sum;
        GroupMemoryBarrierWithGroupSync();
    }
    return shared_sums[from][thread] - count;
}

#endif
