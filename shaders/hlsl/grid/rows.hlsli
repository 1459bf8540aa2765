// Which rows of the domain's cells along x come near a particle, and how much of each.
#ifndef BROOKLET_ROWS
#define BROOKLET_ROWS

struct Rows
{
    int3 low;               // cells, inclusive
    int3 high;
    float reach_squared_m2;
};

Rows RowsNear(float3 x_i_m)
{
    // The search reaches a hair beyond h, so that rounding of a cell's edge loses nobody; the
    // distance itself decides.
    float reach_m = grid.support_m * 1.0001;
    int3 first_cell = 0;
    int3 last_cell = int3(grid.domain_cells) - 1;
#if defined(PERIODIC)
    // Further along a periodic axis are the cells of the other side. There are eight at least.
    int3 around = 8 * int3(grid.seam_cells == grid.domain_cells);
    first_cell -= around;
    last_cell += around;
#endif
    Rows rows;
    rows.low = clamp(int3(floor((x_i_m - reach_m) * grid.inverse_cell_size_per_m)), first_cell, last_cell);
    rows.high = clamp(int3(floor((x_i_m + reach_m) * grid.inverse_cell_size_per_m)), first_cell, last_cell);
    rows.reach_squared_m2 = reach_m * reach_m;
    return rows;
}

// Distance from x to the cell [cell, cell + 1) along one axis, in metres; 0 inside it.
float DistanceToCell(float x_m, int cell)
{
    float low_m = cell * grid.cell_size_m;
    return max(max(low_m - x_m, x_m - (low_m + grid.cell_size_m)), 0.0);
}

// First and last cell of the row at y, dz_m away along z, that the support sphere's chord crosses;
// the first behind the last where it misses the row.
int2 EndsOfRow(float3 x_i_m, Rows rows, float dz_m, int y)
{
    float dy_m = DistanceToCell(x_i_m.y, y);
    float chord_squared_m2 = rows.reach_squared_m2 - dz_m * dz_m - dy_m * dy_m;
    if (chord_squared_m2 <= 0.0)
        return int2(1, 0);
    float chord_m = sqrt(chord_squared_m2);
    return int2(max(int(floor((x_i_m.x - chord_m) * grid.inverse_cell_size_per_m)), rows.low.x),
                min(int(floor((x_i_m.x + chord_m) * grid.inverse_cell_size_per_m)), rows.high.x));
}

// Which of four candidates, of a row from `sorted` to `end`, are within h of particle i. Their loads are under way
// together.
bool4 AreNear(uint i, uint3 x_i, uint4 candidates, uint sorted, uint end)
{
    bool4 near;
    [unroll]
    for (uint k = 0; k < 4; ++k)
    {
        float3 offset = Offset(x_i, UnpackCoordinates(quantized_positions[candidates[k]]));
        near[k] = dot(offset, offset) < 1.0 && candidates[k] != i && sorted + k < end;
    }
    return near;
}

#endif
