// As search.hlsl, in a grid onto which the domain's cells are wrapped: a cell also holds particles
// from a whole number of grids away. Places repeat every 4 h, and would take such a one for near: the
// positions themselves decide.
#ifndef BROOKLET_SEARCH_WRAPPED
#define BROOKLET_SEARCH_WRAPPED

#include "rows.hlsl"

// The first cell from `low` on that is wrapped onto cell 0.
int FirstWrapped(int low, uint cells)
{
    return int((uint(low) + cells - 1) & ~(cells - 1));
}

// The n-th of the cells low to high in the order in which the wrapped ones are sorted.
int Wrapping(int n, int low, int high, uint cells)
{
    int wrapped = FirstWrapped(low, cells);
    int turned = max(high - wrapped + 1, 0);
    return n < turned ? wrapped + n : low + n - turned;
}

void Search(uint i, float3 here_m, inout Found found)
{
    Rows rows = RowsNear(here_m);
    uint3 here = Coordinates(places[i]);
    int2 counts = rows.high.yz - rows.low.yz + 1;
    for (int nz = 0; nz < counts.y; ++nz)
    {
        int z = Wrapping(nz, rows.low.z, rows.high.z, grid.cells.z);
        float dz_m = DistanceToCell(here_m.z, z);
        for (int ny = 0; ny < counts.x; ++ny)
        {
            int y = Wrapping(ny, rows.low.y, rows.high.y, grid.cells.y);
            int2 ends = EndsOfRow(here_m, rows, dz_m, y);
            uint row = ((uint(z) & (grid.cells.z - 1)) * grid.cells.y + (uint(y) & (grid.cells.y - 1))) * grid.cells.x;
            // What is wrapped stands before what is not.
            int wrapped = min(FirstWrapped(ends.x, grid.cells.x), ends.y + 1);
            for (int part = 0; part < 2; ++part)
            {
                int first = part == 0 ? wrapped : ends.x;
                int last = part == 0 ? ends.y : wrapped - 1;
                if (first > last)
                    continue;
                uint start = cell_starts[row + (uint(first) & (grid.cells.x - 1))];
                uint end = cell_starts[row + (uint(last) & (grid.cells.x - 1)) + 1];
                BeginRow(found, start);
                for (uint sorted = start; sorted < end; ++sorted)
                {
                    float3 apart = Apart(here, Coordinates(places[sorted]));
                    bool near = dot(apart, apart) < 1.0 && sorted != i;
                    if (near)
                        near = all(abs(sorted_positions[sorted].position_m - here_m) < 2.0 * grid.support_m);
                    Add(found, sorted, sorted, near);
                }
            }
        }
    }
}

#endif
