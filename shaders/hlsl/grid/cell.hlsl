// Which cell a position is in.
#ifndef BROOKLET_CELL
#define BROOKLET_CELL

#include "../shared/layout.hlsl"

// Row-major, x fastest, so that a run of cells along x is one range of sorted particles. What is
// outside gets the cell behind the last.
uint CellOf(float3 position_m, GridParams grid)
{
    int3 cell = int3(floor(position_m * grid.inverse_cell_size_per_m));
    if (any(cell < 0) || any(cell >= int3(grid.cells)))
        return grid.cell_count;
    return (uint(cell.z) * grid.cells.y + uint(cell.y)) * grid.cells.x + uint(cell.x);
}

#endif
