// What the host tells of the coarse correction (solver/pbf/coarse_correction.hlsli).
#ifndef BROOKLET_PBF_LAYOUT
#define BROOKLET_PBF_LAYOUT

// Cells along each side of what one group relaxes.
static const uint COARSE_TILE = 8;
// Units of a constraint in one: sums of integers do not depend on their order.
static const uint CONSTRAINT_UNITS = 32768;
// What lies beyond the ends of a coarse grid's axis: a wall, the other end, or nothing.
static const uint COARSE_WALL = 0;
static const uint COARSE_PERIODIC = 1;
static const uint COARSE_OPEN = 2;

// The particles of a coarse cell.
struct CoarseCell
{
    int constraint_sum;     // of their constraints, in 1/CONSTRAINT_UNITS
    uint particles;
};

// One level of the coarse grid, x fastest. A cell is 2^halvings finest ones wide; the last along an axis may be less.
struct CoarseGridParams
{
    uint3 cells;
    uint halvings;
    uint3 finest_cells;
    uint sweeps;
    float3 inverse_cell_size_per_m;     // of the finest cells; 0 along z in two dimensions
    float mixing;                       // what a unit of the multiplier leaves of the constraint
    float3 conductance;                 // (M h / cell)^2 of the finest cells; 0 along z in two dimensions
    float particles_a_cell;             // of a finest cell that is full at rest
    uint3 ends;                         // COARSE_WALL, COARSE_PERIODIC or COARSE_OPEN
    float most;                         // a multiplier is no more
    float least;                        // and no less
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

#endif
