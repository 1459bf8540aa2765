// The way of a particle among solids. Includers declare `solids`, `solid_poses`, `solid_fields`, `solid_blocks`,
// `solids_params` and `step_params`. With BODIES they give back what they do to particles (boundary/bodies/react.hlsli).
#ifndef BROOKLET_COLLIDE
#define BROOKLET_COLLIDE

#include "../walls.hlsli"
#include "near.hlsli"
#include "pose.hlsli"
#include "shapes.hlsli"

// Steps along a path, each at least LEAST_STEP of what particles keep from surfaces: what is left of a longer one is lost.
static const uint TRACE_STEPS = 64;
static const float LEAST_STEP = 0.25;
// Share of that within which a particle touches.
static const float TOUCHING = 0.02;
// And within which a path is as it was: more than what rounding takes of it.
static const float UNTOUCHED = 1.0e-3;
// Rounds over the solids near a particle. Who is still in one by more than JAMMED then stays where it was.
static const uint COLLISION_ROUNDS = 3;
static const float JAMMED = 0.5;

// The end of a path in a solid's frame: as far as the particle gets, sliding along what it touches.
float3 TracedPath(Solid solid, float3 place_m, float3 end_m)
{
    float stop_m = solids_params.stop_m;
    float3 rest_m = end_m - place_m;
    float steepness = solid.shape == SHAPE_FIELD ? FIELD_STEEPNESS : 1.0;
    [loop]
    for (uint k = 0; k <= TRACE_STEPS; ++k)
    {
        Surface surface = SurfaceOf(solid, place_m);
        float gap_m = surface.distance_m - stop_m;
        place_m -= surface.normal * min(gap_m, 0.0);
        rest_m -= gap_m <= TOUCHING * stop_m ? surface.normal * min(dot(rest_m, surface.normal), 0.0) : 0.0;
        float length_m = length(rest_m);
        // Nothing is as near as the rest is long: most paths end here, after one look.
        if (gap_m >= steepness * length_m)
            return place_m + rest_m;
        // Who was pushed out is looked at once more.
        if (k == TRACE_STEPS || (length_m <= UNTOUCHED * stop_m && gap_m >= -UNTOUCHED * stop_m))
            break;
        float share = min(max(gap_m / steepness, LEAST_STEP * stop_m) / max(length_m, 1.0e-30), 1.0);
        place_m += rest_m * share;
        rest_m -= rest_m * share;
    }
    return place_m;
}

// The same, with what friction takes of the way along the surface (Coulomb) and what restitution gives back across it: the way
// from where the particle is stopped. A loop, so that the shapes' code is there once.
float3 ContactPath(Solid solid, float3 place_m, float3 end_m)
{
    float3 stopped_m = place_m;
    float3 goal_m = end_m;
    [loop]
    for (uint way = 0; way < 2; ++way)
    {
        stopped_m = TracedPath(solid, stopped_m, goal_m);
        float3 pushed_m = stopped_m - end_m;
        float push_m = length(pushed_m);
        if (way == 1 || push_m <= UNTOUCHED * solids_params.stop_m || solid.friction + solid.restitution == 0.0)
            break;
        float3 normal = pushed_m / push_m;
        float3 slid_m = stopped_m - place_m;
        slid_m -= normal * dot(slid_m, normal);
        float slid_length_m = length(slid_m);
        float3 held_m = slid_m * min(solid.friction * push_m / max(slid_length_m, 1.0e-30), 1.0);
        goal_m = stopped_m - held_m + solid.restitution * pushed_m;
    }
    return stopped_m;
}

// The end of a particle's path among all solids that it may meet, and inside the domain's walls. `moving`: whether solids
// move along it, or stand where they are at the substep's end.
float3 PathAmongSolids(float3 start_m, float3 end_m, bool moving)
{
    uint4 mask = SolidsNear(end_m);
    if (all(mask == 0))
        return end_m;
    [loop]
    for (uint round = 0; round < COLLISION_ROUNDS; ++round)
    {
        float furthest_m = 0.0;
        [loop]
        for (uint word = 0; word < SOLID_MASK_WORDS; ++word)
        {
            uint bits = word == 0 ? mask.x : word == 1 ? mask.y : word == 2 ? mask.z : mask.w;
            [loop]
            while (bits != 0)
            {
                uint s = 32 * word + firstbitlow(bits);
                bits &= bits - 1;
                // A block's solids are mostly beside the path: their boxes alone are read of them.
                if (IsBeside(s, min(start_m, end_m), max(start_m, end_m), solids_params.stop_m))
                    continue;
                Solid solid = solids[s];
                SolidPose pose = solid_poses[s];
                float3 from_m = moving ? InFrame(start_m, pose.before_m, pose.rotation_before)
                                       : InFrame(start_m, pose.position_m, pose.rotation);
                float3 to_m = InFrame(end_m, pose.position_m, pose.rotation);
                // Too far away to be met.
                float3 nearest_m = max(max(min(from_m, to_m) - solid.extent_m, -solid.extent_m - max(from_m, to_m)), 0.0);
                if (any(nearest_m > solids_params.stop_m))
                    continue;
                float3 pushed_m = ContactPath(solid, from_m, to_m) - to_m;
                float push_m = length(pushed_m);
                if (push_m > UNTOUCHED * solids_params.stop_m)
                {
                    float3 taken_m = Turned(pose.rotation, pushed_m);
                    end_m += taken_m;
#if defined(BODIES)
                    if (solid.body != NO_BODY)
                        React(solid.body, end_m, taken_m / step_state.dt_s);
#endif
                }
                furthest_m = max(furthest_m, push_m);
            }
        }
        end_m = InsideWalls(end_m, step_params);
        if (furthest_m <= TOUCHING * solids_params.stop_m)
            return end_m;
        if (round + 1 == COLLISION_ROUNDS && furthest_m > JAMMED * solids_params.stop_m)
            return start_m;
    }
    return end_m;
}

#endif
