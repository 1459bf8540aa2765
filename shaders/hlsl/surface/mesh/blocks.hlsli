// Blocks by number, their points, and the field where it is the same throughout.
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

// Whether a point of the grid lies beyond the walls, or is one of the grid's outermost: the fluid ends before it.
bool IsBeyond(uint3 grid_point, MeshParams mesh)
{
    return any(grid_point < mesh.low_point) || any(grid_point > mesh.high_point);
}

// The field at a point of a block that is all inside, or all outside.
float UniformField(bool is_inside, uint3 grid_point, MeshParams mesh)
{
    return IsBeyond(grid_point, mesh) ? BEYOND_M : is_inside ? mesh.spacing_m : -mesh.spacing_m;
}

#endif
