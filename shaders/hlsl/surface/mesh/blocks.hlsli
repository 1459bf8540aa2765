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

// The block of an entry of the list.
uint BlockOf(uint listed)
{
    return listed & ~(BLOCK_UNIFORM | BLOCK_UNIFORM_INSIDE);
}

// The field at every point of a block that is all inside, or all outside.
FieldPoint UniformField(bool is_inside, MeshParams mesh)
{
    FieldPoint result;
    result.gradient = 0.0;
    result.field_m = is_inside ? mesh.spacing_m : -mesh.spacing_m;
    return result;
}

#endif
