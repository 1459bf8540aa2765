// The fluid mirrored in the domain's walls: behind each flat wall goes on what stands before it, as wet and as fast the other
// way, so that a wall, an edge and a corner are as dense and as calm as the middle, pressure's slope along a wall is the
// fluid's own, and a pair and its image push each other equally. A particle's image is nearer to another than itself only
// beyond the wall, so whom it mirrors is in the list already.
//
// The wall-weight function (walls.hlsli) knows only where a particle is, not its neighbours. With it a divergence-free solve
// held .72 of a pool's weight at the floor, the rest stood on the stop at the wall, and it moved at .45 m/s; with images it
// is .999 and .03 (CPU trials in f64, 4,000 particles, h = 2 d).
#ifndef BROOKLET_MIRROR
#define BROOKLET_MIRROR

#include "../shared/layout.hlsli"

// Further than any image reaches, in h.
static const float NO_WALL = 2.0;

#if defined(WALLS)

// The images of what a particle sees: those in the nearest wall of each axis, and in two and three of them.
struct Mirrors
{
    float3 twice_to_wall;   // from the wall, signed, in the units of offsets
    uint3 bits;             // of an image's number, that are set where it is mirrored along the axis; 0 where no wall is near
    uint count;             // with the particle itself, which is image 0
};

// From the nearest wall of each axis, signed, in h; NO_WALL where it is further away than that.
float3 FromWalls(float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    float3 low = min((position_m - step.wall_min_m) * kernel.inverse_support_per_m, NO_WALL);
    float3 high = min((step.wall_max_m - position_m) * kernel.inverse_support_per_m, NO_WALL);
    return low <= high ? low : -high;
}

// Offsets are in units of which `supports_per_unit` make h.
Mirrors MirrorsAt(float3 from_walls, float supports_per_unit)
{
    uint3 near = abs(from_walls) < 1.0 ? 1u : 0u;
    Mirrors mirrors;
    mirrors.twice_to_wall = from_walls * (2.0 / supports_per_unit);
    mirrors.bits = near << uint3(0, near.x, near.x + near.y);
    mirrors.count = 1u << (near.x + near.y + near.z);
    return mirrors;
}

// From an image of x_j to x_i, of the offset from x_j itself.
float3 ImageOffset(float3 offset, Mirrors mirrors, uint image)
{
    return (mirrors.bits & image) != 0 ? mirrors.twice_to_wall - offset : offset;
}

// A direction as it is in an image, or back.
float3 Mirrored(float3 direction, Mirrors mirrors, uint image)
{
    return (mirrors.bits & image) != 0 ? -direction : direction;
}

#else

float3 FromWalls(float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    return NO_WALL;
}

#endif

#endif
