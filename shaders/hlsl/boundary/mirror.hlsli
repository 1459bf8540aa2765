// The fluid mirrored in the domain's walls: behind each flat wall goes on what stands before it, as wet and as fast the other
// way, so that a wall, an edge and a corner are as dense and as calm as the middle, pressure's slope along a wall is the
// fluid's own, and a pair and its image push each other equally. A particle's image is nearer to another than itself only
// beyond the wall, so whom it mirrors is in the list already.
//
// The wall-weight function (walls.hlsli) knows only where a particle is, not its neighbours. With it a divergence-free solve
// held .72 of a pool's weight at the floor, the rest stood on the stop at the wall, and it moved at .45 m/s; with images it
// is .999 and .03 (CPU trials in f64, 4,000 particles, h = 2 d).
//
// With SOLID_WALLS also in the half-space that stands for the solids near a particle (boundary/solids/sample_solids.compute),
// which may move. Whom that half-space holds, as it does around a solid's edge, has no image in it.
#ifndef BROOKLET_MIRROR
#define BROOKLET_MIRROR

#include "../shared/layout.hlsli"
#include "solids/layout.hlsli"

#if defined(SOLID_WALLS) && !defined(WALLS)
#define WALLS
#endif

// Further than any image reaches, in h.
static const float NO_WALL = 2.0;

#if defined(WALLS)

// The images of what a particle sees: those in the nearest wall of each axis, and in two and three of them.
struct Mirrors
{
    float3 twice_to_wall;   // from the wall, signed, in the units of offsets
    uint3 bits;             // of an image's number, that are set where it is mirrored along the axis; 0 where no wall is near
    uint count;             // with the particle itself, which is image 0
#if defined(SOLID_WALLS)
    uint solid_bit;         // of an image's number, that is set where it is mirrored in solids; 0 where none is near
    float3 solid_normal;
    float from_solids;      // in the units of offsets
    float3 twice_solid_m_s; // velocity that the image has besides
    float3 nowhere;         // further than the kernel reaches, in the units of offsets
#endif
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
    float3 at = (mirrors.bits & image) != 0 ? mirrors.twice_to_wall - offset : offset;
#if defined(SOLID_WALLS)
    float from_solids = mirrors.from_solids - dot(mirrors.solid_normal, at);
    float3 mirrored = from_solids > 0.0 ? at + 2.0 * from_solids * mirrors.solid_normal : mirrors.nowhere;
    at = (mirrors.solid_bit & image) != 0 ? mirrored : at;
#endif
    return at;
}

// A direction as it is in an image.
float3 Mirrored(float3 direction, Mirrors mirrors, uint image)
{
    direction = (mirrors.bits & image) != 0 ? -direction : direction;
#if defined(SOLID_WALLS)
    float3 mirrored = direction - 2.0 * dot(mirrors.solid_normal, direction) * mirrors.solid_normal;
    direction = (mirrors.solid_bit & image) != 0 ? mirrored : direction;
#endif
    return direction;
}

// The other way: an image's direction as it is in the particle itself.
float3 MirroredBack(float3 direction, Mirrors mirrors, uint image)
{
#if defined(SOLID_WALLS)
    float3 mirrored = direction - 2.0 * dot(mirrors.solid_normal, direction) * mirrors.solid_normal;
    direction = (mirrors.solid_bit & image) != 0 ? mirrored : direction;
#endif
    return (mirrors.bits & image) != 0 ? -direction : direction;
}

// A velocity as it is in an image.
float3 MirroredVelocity(float3 velocity_m_s, Mirrors mirrors, uint image)
{
    float3 mirrored_m_s = Mirrored(velocity_m_s, mirrors, image);
#if defined(SOLID_WALLS)
    mirrored_m_s += (mirrors.solid_bit & image) != 0 ? mirrors.twice_solid_m_s : 0.0;
#endif
    return mirrored_m_s;
}

#if defined(SOLID_WALLS)

// A direction of length 1 in two words of 16 bits: an octahedron unfolded (Meyer et al. 2010), within 6e-5.
uint PackDirection(float3 direction)
{
    float2 flat = direction.xy / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    float2 side = float2(flat.x < 0.0 ? -1.0 : 1.0, flat.y < 0.0 ? -1.0 : 1.0);
    flat = direction.z < 0.0 ? (1.0 - abs(flat.yx)) * side : flat;
    uint2 bits = uint2(round((0.5 + 0.5 * flat) * 65535.0));
    return bits.x | (bits.y << 16);
}

float3 UnpackDirection(uint packed)
{
    float2 flat = float2(packed & 0xffff, packed >> 16) * (2.0 / 65535.0) - 1.0;
    float3 direction = float3(flat, 1.0 - abs(flat.x) - abs(flat.y));
    float2 side = float2(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0);
    direction.xy = direction.z < 0.0 ? (1.0 - abs(direction.yx)) * side : direction.xy;
    return normalize(direction);
}

// The images of MirrorsAt, and those of all of them in the solids' half-space.
Mirrors MirrorsNear(float3 from_walls, float3 solid_normal, float from_solids, float solid_speed_m_s, float supports_per_unit)
{
    Mirrors mirrors = MirrorsAt(from_walls, supports_per_unit);
    bool near = abs(from_solids) < 1.0;
    mirrors.solid_normal = solid_normal;
    mirrors.from_solids = from_solids / supports_per_unit;
    mirrors.twice_solid_m_s = 2.0 * solid_speed_m_s * mirrors.solid_normal;
    mirrors.nowhere = 2.0 / supports_per_unit;
    mirrors.solid_bit = near ? mirrors.count : 0;
    mirrors.count <<= near ? 1 : 0;
    return mirrors;
}

#endif

#else

float3 FromWalls(float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    return NO_WALL;
}

#endif

#endif
