// The coarse correction: what varies slowly in the density constraint, which local iterations hardly reach, is solved
// for on cells of 2 h as a two-level method does (Brandt 1977), once a substep. A multiplier that varies slowly moves
// particles by -M grad, and so changes their density by M^2 times its Laplacian: on the cells
//
//   mixing L - M^2 lap(L) = mean constraint of the cell's particles,   L >= 0,
//
// with L = 0 in cells that are less than half full, the surface, and no flux through walls. Mixing, as in the
// particles' own lambda, keeps the range of the answer at a few cells: without it a constraint of rounding's size, all
// over a tall column, would ask for a pressure that no particle's neighbours bear. It makes a full, closed box an
// ordinary case, too.
#ifndef BROOKLET_COARSE_CORRECTION
#define BROOKLET_COARSE_CORRECTION

#include "layout.hlsli"

// Of the coarse multiplier, in the first iteration's lambdas. The whole of it overshoots.
static const float COARSE_WEIGHT = 0.3;
// A particle's constraint counts within these: a surface's lack of neighbours is no tension, and what is very
// compressed is the business of the iterations.
static const float LEAST_CONSTRAINT = -0.05;
static const float MOST_CONSTRAINT = 0.25;
// Compression above which a particle takes less of the coarse multiplier, and from which on nothing: its neighbours are
// too close for a pressure that is added at once.
static const float SHARE_BEGIN = 0.12;
static const float SHARE_END = 0.24;
// Cells that are less full belong to the surface.
static const float FULL_ENOUGH = 0.5;

// What a particle takes of the coarse multiplier.
float CoarseShare(float constraint)
{
    return saturate((SHARE_END - constraint) / (SHARE_END - SHARE_BEGIN));
}

// Share and total in the total's place, as f16: the first iteration's total is 0, or a warm start's, of which a thousandth
// more or less is nothing.
float PackShare(float share, float total)
{
    return asfloat(f32tof16(share) | (f32tof16(total) << 16));
}

float UnpackShare(float packed)
{
    return f16tof32(asuint(packed) & 0xffff);
}

float UnpackTotal(float packed)
{
    return f16tof32(asuint(packed) >> 16);
}

uint CoarseIndex(uint3 cell, uint3 cells)
{
    return (cell.z * cells.y + cell.y) * cells.x + cell.x;
}

uint3 CoarseCellAt(uint index, uint3 cells)
{
    return uint3(index % cells.x, index / cells.x % cells.y, index / (cells.x * cells.y));
}

// Cells along each axis at a level.
uint3 CellsAfter(uint3 finest_cells, uint halvings)
{
    return (finest_cells + (1u << halvings) - 1) >> halvings;
}

// How many finest cells a cell is wide along each axis.
uint3 Widths(uint3 cell, CoarseGridParams coarse)
{
    return min(1u << coarse.halvings, coarse.finest_cells - (cell << coarse.halvings));
}

// A cell of the axis: beyond a periodic one's ends that of the other side, else the last.
int OntoAxis(int cell, int cells, uint end)
{
    if (end == COARSE_PERIODIC)
        return cell < 0 ? cell + cells : cell >= cells ? cell - cells : cell;
    return clamp(cell, 0, cells - 1);
}

uint CoarseIndexNear(int3 cell, uint3 cells, uint3 ends)
{
    return CoarseIndex(uint3(OntoAxis(cell.x, int(cells.x), ends.x), OntoAxis(cell.y, int(cells.y), ends.y),
                             OntoAxis(cell.z, int(cells.z), ends.z)), cells);
}

// The multiplier at a place in cells of its grid, linear between their centres.
float Interpolated(StructuredBuffer<float> multipliers, float3 place, uint3 cells, uint3 ends)
{
    float3 low = floor(place - 0.5);
    float3 part = place - 0.5 - low;
    float sum = 0.0;
    [unroll]
    for (uint corner = 0; corner < 8; ++corner)
    {
        int3 step = int3(corner & 1, corner >> 1 & 1, corner >> 2);
        float3 weights = step == 1 ? part : 1.0 - part;
        sum += weights.x * weights.y * weights.z * multipliers[CoarseIndexNear(int3(low) + step, cells, ends)];
    }
    return sum;
}

// Where a particle is in finest cells. In two dimensions it is in the middle of the only one along z.
float3 PlaceOf(float3 position_m, CoarseGridParams coarse)
{
    float3 place = position_m * coarse.inverse_cell_size_per_m;
    place.z += coarse.inverse_cell_size_per_m.z == 0.0 ? 0.5 : 0.0;
    return place;
}

#endif
