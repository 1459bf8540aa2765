// Finds the particles within h of one, for the kernels that say what a sorted place holds and how a
// list is written: they define `Found`, CandidateAt, BeginRow and Add before they include this.
// Rows of cells along x are cut to the chord of the support sphere and are one range of sorted
// places each, so about half as many candidates are looked at as in the 27 cells of width h of the
// mobile deck.
#ifndef BROOKLET_SEARCH
#define BROOKLET_SEARCH

// Distance from x to the cell [cell, cell + 1) along one axis, in metres; 0 inside it.
float DistanceToCell(float x_m, int cell)
{
    float low_m = cell * grid.cell_size_m;
    return max(max(low_m - x_m, x_m - (low_m + grid.cell_size_m)), 0.0);
}

// Visits everything near particle i, which is at here_m, in some cell, in sorted order.
void Search(uint i, float3 here_m, inout Found found)
{
    // The search reaches a hair beyond h, so that rounding of a cell's edge loses nobody; the
    // distance itself decides.
    float reach_m = grid.support_m * 1.0001;
    float reach_squared_m2 = reach_m * reach_m;
    int3 last_cell = int3(grid.cells) - 1;
    int3 low = clamp(int3(floor((here_m - reach_m) * grid.inverse_cell_size_per_m)), 0, last_cell);
    int3 high = clamp(int3(floor((here_m + reach_m) * grid.inverse_cell_size_per_m)), 0, last_cell);

    uint3 here = Coordinates(places[i]);
    for (int z = low.z; z <= high.z; ++z)
    {
        float dz_m = DistanceToCell(here_m.z, z);
        for (int y = low.y; y <= high.y; ++y)
        {
            float dy_m = DistanceToCell(here_m.y, y);
            float chord_squared_m2 = reach_squared_m2 - dz_m * dz_m - dy_m * dy_m;
            if (chord_squared_m2 <= 0.0)
                continue;
            float chord_m = sqrt(chord_squared_m2);
            int first_x = max(int(floor((here_m.x - chord_m) * grid.inverse_cell_size_per_m)), 0);
            int last_x = min(int(floor((here_m.x + chord_m) * grid.inverse_cell_size_per_m)), last_cell.x);
            uint row = (uint(z) * grid.cells.y + uint(y)) * grid.cells.x;
            uint start = cell_starts[row + uint(first_x)];
            uint end = cell_starts[row + uint(last_x) + 1];
            BeginRow(found, start);
            for (uint sorted = start; sorted < end; ++sorted)
            {
                uint j = CandidateAt(sorted);
                float3 apart = Apart(here, Coordinates(places[j]));
                Add(found, sorted, j, dot(apart, apart) < 1.0 && j != i);
            }
        }
    }
}

#endif
