// A corner of the solids' triangles where the GPU has moved it to.
#ifndef BROOKLET_SOLID_GEOMETRY
#define BROOKLET_SOLID_GEOMETRY

#include "layout.hlsli"
#include "../boundary/solids/layout.hlsli"
#include "../boundary/solids/pose.hlsli"

float3 SolidPositionOf(SolidVertex corner, SolidPose pose)
{
    return FromFrame(corner.position_m, pose.position_m, pose.rotation);
}

float3 SolidNormalOf(SolidVertex corner, SolidPose pose)
{
    return Turned(pose.rotation, corner.normal);
}

#endif
