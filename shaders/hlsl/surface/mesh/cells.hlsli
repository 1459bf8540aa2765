// The cells of a listed block: a thread has the cell whose lowest corner is its point. The block's points and the first
// ones of the blocks above it are loaded once, 5 x 5 x 5.
#ifndef BROOKLET_MESH_CELLS
#define BROOKLET_MESH_CELLS

#include "blocks.hlsli"

#define POINTS_A_SIDE (BLOCK_CELLS + 1)
#define POINTS (POINTS_A_SIDE * POINTS_A_SIDE * POINTS_A_SIDE)

groupshared float shared_fields[POINTS];

// The block that a point of this one, or the first of the next ones, belongs to.
uint EntryOf(uint3 block, uint3 at)
{
    uint3 owner = block + at / BLOCK_CELLS;
    return any(owner >= mesh.blocks) ? BLOCK_OUTSIDE : block_entries[BlockNumber(owner, mesh)];
}

// The field at a point of this block, or the first of the next ones.
FieldPoint FieldPointAt(uint3 block, uint3 at)
{
    uint entry = EntryOf(block, at);
    if (entry >= BLOCK_LISTED)
        return field_points[(entry - BLOCK_LISTED) * 64 + PointNumber(at % BLOCK_CELLS)];
    return UniformField(entry == BLOCK_INSIDE, mesh);
}

void LoadFields(uint3 block, uint thread)
{
    for (uint k = thread; k < POINTS; k += 64)
    {
        uint3 at = uint3(k, k / POINTS_A_SIDE, k / POINTS_A_SIDE / POINTS_A_SIDE) % POINTS_A_SIDE;
        shared_fields[k] = FieldPointAt(block, at).field_m;
    }
    GroupMemoryBarrierWithGroupSync();
}

float FieldAt(uint3 at)
{
    return shared_fields[(at.z * POINTS_A_SIDE + at.y) * POINTS_A_SIDE + at.x];
}

// Which corners of the cell are inside, a bit each.
uint CornersInside(uint3 cell)
{
    uint inside = 0;
    [unroll]
    for (uint corner = 0; corner < 8; ++corner)
        inside |= FieldAt(cell + uint3(corner & 1, corner >> 1 & 1, corner >> 2)) > 0.0 ? 1u << corner : 0u;
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
