// The neighbour list: slices of LIST_SLICE particles, in each the particles' first four neighbours
// side by side, then their next four (sliced ELLPACK, Monakov et al. 2010). A group reads one run
// of memory from end to end, where lists of one slot of all particles after the other are as many
// streams as there are slots, more than a CPU's or a phone's caches follow. The last four are
// filled up with the particle itself, which has no distance from itself and so no effect, but for
// its own W(0).
#ifndef BROOKLET_LIST
#define BROOKLET_LIST

#include "layout.hlsl"

// Where the first four neighbours of particle i stand; the next are LIST_SLICE further.
uint FirstChunk(uint i, uint chunks_a_list)
{
    return i / LIST_SLICE * LIST_SLICE * chunks_a_list + i % LIST_SLICE;
}

uint ChunksOf(uint neighbours)
{
    return (neighbours + LIST_CHUNK - 1) / LIST_CHUNK;
}

#endif
