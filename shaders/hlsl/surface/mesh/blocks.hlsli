// Blocks by number, and the bins of particles around them.
#ifndef BROOKLET_MESH_BLOCKS
#define BROOKLET_MESH_BLOCKS

#include "layout.hlsli"

uint3 BlockAt(uint block, MeshParams mesh)
{
    return uint3(block % mesh.blocks.x, block / mesh.blocks.x % mesh.blocks.y, block / mesh.blocks.x / mesh.blocks.y);
}

uint BlockNumber(uint3 at, MeshParams mesh)
{
    return (at.z * mesh.blocks.y + at.y) * mesh.blocks.x + at.x;
}

// A thread's point in its block, x fastest.
uint3 PointAt(uint thread)
{
    return uint3(thread, thread / BLOCK_CELLS, thread / BLOCK_CELLS / BLOCK_CELLS) % BLOCK_CELLS;
}

uint PointNumber(uint3 at)
{
    return (at.z * BLOCK_CELLS + at.y) * BLOCK_CELLS + at.x;
}

#endif
