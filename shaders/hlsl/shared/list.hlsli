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

// The deltas of four neighbours.
uint4 UnpackDeltas(uint2 chunk)
{
    return uint4(chunk.x & 0xffff, chunk.x >> 16, chunk.y & 0xffff, chunk.y >> 16);
}

// Where a walk along a particle's list is. Every walk reads
//
//     for (NeighbourCursor cursor = BeginNeighbours(i, list_heads[i], chunks_per_list); HasNeighbours(cursor);
//          NextChunk(cursor))
//     {
//         uint4 deltas = UnpackDeltas(neighbours[cursor.chunk]);
//         [unroll]
//         for (uint k = 0; k < LIST_CHUNK; ++k)
//             ... NextNeighbour(cursor, deltas[k], i) ...
//     }
//
// so that four neighbours are one load, and their gathers are under way together.
struct NeighbourCursor
{
    uint chunk;         // the four that are next, or under way
    uint chunks_left;
    uint last;          // sorted index that the next delta is counted from
};

NeighbourCursor BeginNeighbours(uint i, ListHead head, uint chunks_per_list)
{
    NeighbourCursor cursor;
    cursor.chunk = FirstChunk(i, chunks_per_list);
    cursor.chunks_left = (head.entries + LIST_CHUNK - 1) / LIST_CHUNK;
    cursor.last = head.first - 1;
    return cursor;
}

bool HasNeighbours(NeighbourCursor cursor)
{
    return cursor.chunks_left > 0;
}

void NextChunk(inout NeighbourCursor cursor)
{
    cursor.chunk += LIST_SLICE;
    --cursor.chunks_left;
}

// The next neighbour of particle i, or i itself where the delta is an escape.
uint NextNeighbour(inout NeighbourCursor cursor, uint delta, uint i)
{
    cursor.last += delta == LIST_ESCAPE ? LIST_ESCAPE_DELTA : delta;
    return delta == LIST_ESCAPE ? i : cursor.last;
}

#endif
