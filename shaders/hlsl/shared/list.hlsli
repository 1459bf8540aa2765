// The neighbour list. Slices of LIST_SLICE particles, in each the particles' first four neighbours
// side by side, then their next four (sliced ELLPACK, Monakov et al. 2010): a group reads one run of
// memory from end to end, where lists of one slot of all particles after the other are as many
// streams as there are slots, more than a CPU's or a phone's caches follow.
//
// A neighbour is 16 bits: how far it is behind the one before, as neighbours are listed in the order
// in which they are sorted. LIST_ESCAPE stands for the particle itself, which has no distance from
// itself and so no effect, but for its own W(0); it fills up the last four, and takes a list over a
// delta wider than 16 bits.
#ifndef BROOKLET_LIST
#define BROOKLET_LIST

#include "layout.hlsli"

// Where the first four neighbours of particle i stand; the next are LIST_SLICE further.
uint FirstChunk(uint i, uint chunks_a_list)
{
    return i / LIST_SLICE * LIST_SLICE * chunks_a_list + i % LIST_SLICE;
}

uint ChunkCount(ListHead head)
{
    return (head.entries + LIST_CHUNK - 1) / LIST_CHUNK;
}

// The deltas of four neighbours.
uint4 UnpackDeltas(uint2 chunk)
{
    return uint4(chunk.x & 0xffff, chunk.x >> 16, chunk.y & 0xffff, chunk.y >> 16);
}

// The next neighbour of particle i, or i itself. `last` is where the list is, from before its first.
uint NextNeighbour(inout uint last, uint delta, uint i)
{
    last += delta == LIST_ESCAPE ? LIST_MAX_DELTA : delta;
    return delta == LIST_ESCAPE ? i : last;
}

#endif
