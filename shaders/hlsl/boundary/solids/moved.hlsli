// How what of a solid is at a place moved in the substep.
#ifndef BROOKLET_MOVED
#define BROOKLET_MOVED

#include "layout.hlsli"
#include "pose.hlsli"

float3 MovedBy(SolidPose pose, float3 at_m)
{
    float3 place_m = InFrame(at_m, pose.position_m, pose.rotation);
    return at_m - FromFrame(place_m, pose.before_m, pose.rotation_before);
}

#endif
