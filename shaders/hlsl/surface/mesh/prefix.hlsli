// Sums over a group of 64 threads of numbers below 8, through one barrier: bit k of every number is in the k-th plane, a
// bit a thread, and counting bits adds them up.
#ifndef BROOKLET_MESH_PREFIX
#define BROOKLET_MESH_PREFIX

#define PLANES 6

groupshared uint2 shared_planes[PLANES];

// To be called before a barrier that comes before AddToPlanes.
void ClearPlanes(uint thread)
{
    if (thread < PLANES)
        shared_planes[thread] = 0;
}

// Puts a number into three planes from `first` on. A barrier has to follow.
void AddToPlanes(uint first, uint number, uint thread)
{
    [unroll]
    for (uint k = 0; k < 3; ++k)
    {
        if ((number >> k & 1) != 0)
            InterlockedOr(shared_planes[first + k][thread / 32], 1u << thread % 32);
    }
}

// The sum of the numbers in these planes over the threads before `end`, at most 64.
uint SumBefore(uint first, uint end)
{
    uint2 before = uint2(end < 32 ? (1u << end) - 1 : 0xffffffff, end <= 32 ? 0 : end < 64 ? (1u << (end - 32)) - 1 : 0xffffffff);
    uint sum = 0;
    [unroll]
    for (uint k = 0; k < 3; ++k)
    {
        uint2 bits = shared_planes[first + k] & before;
        sum += (countbits(bits.x) + countbits(bits.y)) << k;
    }
    return sum;
}

#endif
