// What bounds the fluid, as solvers and measures ask it: how much density it adds at a position and with which
// gradient, how it scales what the fluid's own neighbours push, and where it lets a particle be. Walls are the first answer. Other boundaries enter here as data that SampleBoundary reads, not as keywords,
// which would double the modules.
//
// Two keywords: WALLS, for an open scene has no boundary, and none of this is in its shaders. Walls too far away to
// matter gave it the same bits, but took 5 to 9 % more of constrain_density and 1 to 5 % of correct_positions
// (colliding-drops at 2,828 and 23,016 particles, lavapipe; list_neighbours, the same in both, was within 1 %).
// SOLID_WALLS: the same with solids, whose includers declare `solid_contacts` of each particle (boundary/solids).
#ifndef BROOKLET_BOUNDARY
#define BROOKLET_BOUNDARY

#include "../shared/layout.hlsli"

#if defined(SOLID_WALLS)
#define WALLS
#include "solids/sample.hlsli"
#endif

struct BoundarySample
{
    float density;              // the density ratio that it adds
    float3 gradient;            // of that over the position, 1/h
    float3 correction_scale;    // what the fluid's own correction is multiplied by along each axis
    float3 borne;               // of the fluid's weight across walls, where its pressure goes on beyond as in fluid at rest
#if defined(SOLID_WALLS)
    SolidSample solids;         // what of it is theirs
#endif
};

#if defined(WALLS)

#include "walls.hlsli"

BoundarySample SampleBoundary(float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    WallKernelFractions walls = WallKernelFractionsAt(position_m, step, kernel);
    BoundarySample boundary;
    boundary.density = WallDensity(walls, kernel);
    boundary.gradient = WallGradient(walls, kernel);
    boundary.correction_scale = AlongWalls(walls, kernel);
    boundary.borne = WallBorne(walls, kernel);
    return boundary;
}

#if defined(SOLID_WALLS)

// At a place where particle i is during a substep. Shares of walls and of solids add up as independent ones do.
BoundarySample SampleBoundaryNear(uint i, float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    BoundarySample boundary = SampleBoundary(position_m, step, kernel);
    boundary.solids = SampleSolidsNear(solid_contacts[i], position_m, kernel);
    float left = saturate(1.0 - boundary.density);
    boundary.solids.gradient *= left;
    boundary.gradient = boundary.gradient * (1.0 - saturate(boundary.solids.density)) + boundary.solids.gradient;
    boundary.density += boundary.solids.density * left;
    return boundary;
}

// What the fluid's own neighbours push, as the boundary scales it.
float3 ScaledPush(BoundarySample boundary, float3 push)
{
    return AlongSolids(boundary.solids, push * boundary.correction_scale);
}

// The position, moved to where the boundary lets particle i be.
float3 ConfinePositionNear(uint i, float3 position_m, StepParams step)
{
    return InsideWalls(OutsideSolids(solid_contacts[i], position_m), step);
}

#endif

// The position, moved to where the boundary lets a particle be.
float3 ConfinePosition(float3 position_m, StepParams step)
{
    return InsideWalls(position_m, step);
}

// The end of a free path, confined. What the boundary takes of the path it takes of the velocity, an inelastic contact: the
// force m (d - s) n / dt^2 of Harada, Koshizuka & Kawaguchi 2007, eq. 11, of the distance s where the particle would be. A particle put far
// outside would come back at any speed, even one that is not finite.
void ConfinePath(inout float3 position_m, inout float3 velocity_m_s, float dt_s, StepParams step)
{
    float3 inside_m = ConfinePosition(position_m, step);
    velocity_m_s = clamp(velocity_m_s + (inside_m - position_m) / dt_s, -step.max_speed_m_s, step.max_speed_m_s);
    position_m = inside_m;
}

// The end of a free path, mirrored where it is beyond the boundary, and as much shorter as the particle is slower.
void BouncePath(inout float3 position_m, inout float3 velocity_m_s, float restitution, StepParams step)
{
    float3 inside_m = ConfinePosition(position_m, step);
    float3 beyond_m = position_m - inside_m;
    position_m = ConfinePosition(inside_m - restitution * beyond_m, step);
    velocity_m_s *= beyond_m * velocity_m_s > 0.0 ? -restitution : 1.0;
}

#else

BoundarySample SampleBoundary(float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    BoundarySample boundary;
    boundary.density = 0.0;
    boundary.gradient = 0.0;
    boundary.correction_scale = 1.0;
    boundary.borne = 0.0;
    return boundary;
}

float3 ConfinePosition(float3 position_m, StepParams step)
{
    return position_m;
}

void ConfinePath(inout float3 position_m, inout float3 velocity_m_s, float dt_s, StepParams step)
{
}

void BouncePath(inout float3 position_m, inout float3 velocity_m_s, float restitution, StepParams step)
{
}

#endif

#if !defined(SOLID_WALLS)

BoundarySample SampleBoundaryNear(uint i, float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    return SampleBoundary(position_m, step, kernel);
}

float3 ScaledPush(BoundarySample boundary, float3 push)
{
    return push * boundary.correction_scale;
}

float3 ConfinePositionNear(uint i, float3 position_m, StepParams step)
{
    return ConfinePosition(position_m, step);
}

#endif

#endif
