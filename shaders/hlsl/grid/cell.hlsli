// Which cell a position is in.
#ifndef BROOKLET_CELL
#define BROOKLET_CELL

#include "../shared/layout.hlsli"
#include "../shared/tag.hlsli"

// Row-major, x fastest, so that a run of cells along x is one range of sorted particles. What is
// outside gets the cell behind the last.
uint CellOf(float3 position_m, GridParams grid)
{
    float3 cell_position = floor(position_m * grid.inverse_cell_size_per_m);
#if defined(PERIODIC)
    // The product may round what is just below the seam onto it.
    cell_position = min(cell_position, float3(grid.seam_cells) - 1.0);
#endif
    // Compared before the conversion: beyond the integers' range its result is anything.
    if (any(cell_position < 0.0) || any(cell_position >= float3(grid.domain_cells)))
        return grid.cell_count;
    uint3 cell = uint3(cell_position);
#if defined(WRAPPED)
    cell &= grid.cells - 1;
#endif
    return (cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x;
}

// The cell that a slot is sorted into: behind those of the domain what is quarantined, behind it inactive slots.
uint CellOfSlot(Position position, GridParams grid)
{
    if (IsInactive(position.tag))
        return grid.cell_count + 1;
    return IsQuarantined(position.tag) ? grid.cell_count : CellOf(position.position_m, grid);
}

#endif
