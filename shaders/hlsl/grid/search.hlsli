// Finds the particles within h of one, for the kernels that say what a sorted slot holds and how a
// list is written: they define `Found`, CandidateAt, BeginRow, AddFour and Crowd before they include this.
// Rows of cells along x are cut to the chord of the support sphere and are one range of
// sorted indices each, so about half as many candidates are looked at as in the 27 cells of width h of the
// mobile deck.
#ifndef BROOKLET_SEARCH
#define BROOKLET_SEARCH

#include "rows.hlsli"

// Visits everything near particle i, which is at x_i_m, in some cell, in sorted order.
void Search(uint i, float3 x_i_m, inout Found found)
{
    Rows rows = RowsNear(x_i_m);
    uint3 x_i = UnpackCoordinates(quantized_positions[i]);
    uint left = MAX_CANDIDATES;
    for (int z = rows.low.z; z <= rows.high.z; ++z)
    {
        float dz_m = DistanceToCell(x_i_m.z, z);
        for (int y = rows.low.y; y <= rows.high.y; ++y)
        {
            int2 ends = EndsOfRow(x_i_m, rows, dz_m, y);
            if (ends.x > ends.y)
                continue;
            uint row = (uint(z) * grid.cells.y + uint(y)) * grid.cells.x;
            uint start = cell_starts[row + uint(ends.x)];
            uint end = cell_starts[row + uint(ends.y) + 1];
            if (end - start > left)
            {
                end = start + left;
                Crowd(found);
            }
            left -= end - start;
            BeginRow(found, start);
            for (uint sorted = start; sorted < end; sorted += 4)
            {
                uint4 candidates;
                [unroll]
                for (uint k = 0; k < 4; ++k)
                    candidates[k] = CandidateAt(min(sorted + k, end - 1));
                AddFour(found, sorted, candidates, AreNear(i, x_i, candidates, sorted, end));
            }
        }
    }
}

#endif
