// As search.hlsli, where a cell of the grid stands for others of the domain too.
//
// PERIODIC: cells beyond the seam of a periodic axis are those of the other side.
// WRAPPED: in a grid onto which the domain's cells are wrapped, a cell also holds particles from a
// whole number of grids away. Quantized positions repeat every 4 h, and would take such a one for near: the
// positions themselves decide.
//
// Both turn over at multiples of eight cells alone, and a search is narrower than that: of the cells
// it visits along an axis, those from the turn on stand in cell 0 and up, before the others.
#ifndef BROOKLET_SEARCH_WRAPPED
#define BROOKLET_SEARCH_WRAPPED

#include "rows.hlsli"

// The first cell from `low` on that stands in cell 0.
int FirstTurned(int low, uint cells, uint seam)
{
#if defined(PERIODIC)
    int turned = low <= 0 ? 0 : int(seam);
#else
    int turned = 0x7fffffff;
#endif
#if defined(WRAPPED)
    turned = min(turned, (low + int(cells) - 1) & ~(int(cells) - 1));
#endif
    return turned;
}

// The cell of the grid in which one of the domain stands.
uint Onto(int cell, uint cells, uint seam)
{
#if defined(PERIODIC)
    cell += cell < 0 ? int(seam) : 0;
    cell -= cell >= int(seam) ? int(seam) : 0;
#endif
#if defined(WRAPPED)
    cell &= int(cells) - 1;
#endif
    return uint(cell);
}

// The n-th of the cells low to high in the order in which their particles are sorted.
int Turning(int n, int low, int high, uint cells, uint seam)
{
    int first = FirstTurned(low, cells, seam);
    int turned = max(high - first + 1, 0);
    return n < turned ? first + n : low + n - turned;
}

// Whether a particle is near indeed, and not some grids away.
bool IsNear(float3 x_i_m, float3 x_j_m)
{
    float3 offset_m = abs(x_j_m - x_i_m);
#if defined(PERIODIC)
    offset_m = min(offset_m, abs(float3(grid.seam_cells) * grid.cell_size_m - offset_m));
#endif
    return all(offset_m < 2.0 * grid.support_m);
}

void Search(uint i, float3 x_i_m, inout Found found)
{
    Rows rows = RowsNear(x_i_m);
    uint3 x_i = UnpackCoordinates(quantized_positions[i]);
    uint left = MAX_CANDIDATES;
    int2 counts = rows.high.yz - rows.low.yz + 1;
    for (int nz = 0; nz < counts.y; ++nz)
    {
        int z = Turning(nz, rows.low.z, rows.high.z, grid.cells.z, grid.seam_cells.z);
        float dz_m = DistanceToCell(x_i_m.z, z);
        uint plane = Onto(z, grid.cells.z, grid.seam_cells.z) * grid.cells.y;
        for (int ny = 0; ny < counts.x; ++ny)
        {
            int y = Turning(ny, rows.low.y, rows.high.y, grid.cells.y, grid.seam_cells.y);
            int2 ends = EndsOfRow(x_i_m, rows, dz_m, y);
            uint row = (plane + Onto(y, grid.cells.y, grid.seam_cells.y)) * grid.cells.x;
            int turned = min(FirstTurned(ends.x, grid.cells.x, grid.seam_cells.x), ends.y + 1);
            for (int part = 0; part < 2; ++part)
            {
                int first = part == 0 ? turned : ends.x;
                int last = part == 0 ? ends.y : turned - 1;
                if (first > last)
                    continue;
                uint start = cell_starts[row + Onto(first, grid.cells.x, grid.seam_cells.x)];
                uint end = cell_starts[row + Onto(last, grid.cells.x, grid.seam_cells.x) + 1];
                if (end - start > left)
                {
                    end = start + left;
                    Crowd(found);
                }
                left -= end - start;
                BeginRow(found, start);
                for (uint sorted = start; sorted < end; sorted += 4)
                {
                    uint4 candidates = min(sorted + uint4(0, 1, 2, 3), end - 1);
                    bool4 near = AreNear(i, x_i, candidates, sorted, end);
#if defined(WRAPPED)
                    [unroll]
                    for (uint k = 0; k < 4; ++k)
                    {
                        if (near[k])
                            near[k] = IsNear(x_i_m, sorted_positions[candidates[k]].position_m);
                    }
#endif
                    AddFour(found, sorted, candidates, near);
                }
            }
        }
    }
}

#endif
