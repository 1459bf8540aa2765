// The cells of a listed block: a thread has the cell whose lowest corner is its point. Which of its points, and of the
// first ones of the blocks above it, are inside is loaded once, a bit each.
#ifndef BROOKLET_MESH_CELLS
#define BROOKLET_MESH_CELLS

#include "blocks.hlsli"

// Of a block and of the seven above it along some axes, a bit of the number an axis.
groupshared uint2 shared_inside[8];

// Which of these eight blocks a point belongs to.
uint OwnerOf(uint3 at)
{
    return at.x / BLOCK_CELLS | at.y / BLOCK_CELLS << 1 | at.z / BLOCK_CELLS << 2;
}

uint3 OwnerAt(uint3 block, uint owner)
{
    return block + uint3(owner & 1, owner >> 1 & 1, owner >> 2);
}

void LoadInside(uint3 block, uint thread)
{
    if (thread < 8)
    {
        uint3 owner = OwnerAt(block, thread);
        shared_inside[thread] = any(owner >= mesh.blocks) ? uint2(0, 0) : block_inside[BlockNumber(owner, mesh)];
    }
    GroupMemoryBarrierWithGroupSync();
}

// Whether these blocks are not all inside, and not all outside.
bool MayBeCut()
{
    uint2 any_inside = 0;
    uint2 all_inside = 0xffffffff;
    [unroll]
    for (uint owner = 0; owner < 8; ++owner)
    {
        any_inside |= shared_inside[owner];
        all_inside &= shared_inside[owner];
    }
    return any(any_inside != 0) && any(all_inside != 0xffffffff);
}

bool IsInside(uint3 at)
{
    uint p = PointNumber(at % BLOCK_CELLS);
    return (shared_inside[OwnerOf(at)][p / 32] >> p % 32 & 1) != 0;
}

// Which corners of the cell are inside, a bit each.
uint CornersInside(uint3 cell)
{
    uint inside = 0;
    [unroll]
    for (uint corner = 0; corner < 8; ++corner)
        inside |= IsInside(cell + uint3(corner & 1, corner >> 1 & 1, corner >> 2)) ? 1u << corner : 0u;
    return inside;
}

// Which of the three edges from the cell's lowest corner the surface cuts, a bit an axis.
uint CutEdges(uint inside)
{
    uint from = (inside & 1) * 7;
    uint to = (inside >> 1 & 1) | (inside >> 2 & 1) << 1 | (inside >> 4 & 1) << 2;
    return from ^ to;
}

#endif
