// The bins of particles that are in reach of some points, as they are and mirrored at walls.
#ifndef BROOKLET_MESH_BINS
#define BROOKLET_MESH_BINS

#include "layout.hlsli"

// Each axis shows the particles as they are, behind the lower wall and behind the upper one.
#define IMAGES 27
// Walls that are nearer than this are walls.
#define FAR_M 1.0e14

uint BinNumber(uint3 bin, MeshParams mesh)
{
    return (bin.z * mesh.bins.y + bin.y) * mesh.bins.x + bin.x;
}

// Cells that a particle reaches along each axis. What its last thousandth of a cell misses weighs nothing.
int3 ReachCells(MeshParams mesh)
{
    return int3(ceil(mesh.reach_m / mesh.cell_m - 1e-3));
}

// Some bins, and where their particles are seen: sign * x + shift.
struct SeenBins
{
    uint3 low;
    uint3 high;
    float3 sign;
    float3 shift_m;
};

// The bins whose particles, seen as an image has them, may reach the points from `first` to `last`, in cells from the
// domain's lowest corner. False: there are none.
bool BinsInReach(uint image, int3 first, int3 last, MeshParams mesh, out SeenBins bins)
{
    uint3 seen = uint3(image, image / 3, image / 9) % 3;
    int3 reach = ReachCells(mesh);
    int3 cells = int3(mesh.cells);
    bool exists = true;
    bins.sign = 1.0;
    bins.shift_m = 0.0;
    int3 low = first - reach;
    int3 high = last + reach;
    [unroll]
    for (uint axis = 0; axis < 3; ++axis)
    {
        if (seen[axis] == 0)
            continue;
        bool is_low = seen[axis] == 1;
        float wall_m = is_low ? mesh.wall_min_m[axis] : mesh.wall_max_m[axis];
        int twice = is_low ? 0 : 2 * cells[axis];
        int mirrored_low = twice - high[axis];
        high[axis] = twice - low[axis];
        low[axis] = mirrored_low;
        bins.sign[axis] = -1.0;
        bins.shift_m[axis] = 2.0 * wall_m;
        exists = exists && abs(wall_m) < FAR_M && high[axis] >= 0 && low[axis] <= cells[axis];
    }
    bins.low = uint3(clamp(low, 0, cells - 1)) / mesh.bin_cells;
    bins.high = uint3(clamp(high, 0, cells - 1)) / mesh.bin_cells;
    return exists;
}

#endif
