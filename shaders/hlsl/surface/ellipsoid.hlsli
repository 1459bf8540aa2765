// A particle's ellipsoid as it is stored: its center, and a symmetric matrix without unit that
// stretches the particle's sphere into it, six numbers in f16. Half a rounding of f16 moves the
// surface by a fortieth of a percent of its radius.
#ifndef BROOKLET_ELLIPSOID
#define BROOKLET_ELLIPSOID

#include "layout.hlsli"

uint Halves(float low, float high)
{
    return f32tof16(low) | (f32tof16(high) << 16);
}

// `diagonal` is xx, yy, zz; `beside` is xy, xz, yz.
uint3 PackedStretch(float3 diagonal, float3 beside)
{
    return uint3(Halves(diagonal.x, diagonal.y), Halves(diagonal.z, beside.x), Halves(beside.y, beside.z));
}

float3x3 StretchOf(uint3 packed)
{
    float xx = f16tof32(packed.x), yy = f16tof32(packed.x >> 16), zz = f16tof32(packed.y);
    float xy = f16tof32(packed.y >> 16), xz = f16tof32(packed.z), yz = f16tof32(packed.z >> 16);
    return float3x3(xx, xy, xz, xy, yy, yz, xz, yz, zz);
}

// A symmetric matrix's inverse times its determinant, and that: the volume it stretches a unit of volume to.
float3x3 CofactorsOf(float3x3 stretch, out float volume)
{
    float3 x = cross(stretch[1], stretch[2]);
    volume = dot(stretch[0], x);
    return float3x3(x, cross(stretch[2], stretch[0]), cross(stretch[0], stretch[1]));
}

// Where a symmetric matrix stretches v from.
float3 Unstretched(float3x3 stretch, float3 v)
{
    float volume;
    float3x3 cofactors = CofactorsOf(stretch, volume);
    return mul(cofactors, v) / volume;
}

#endif
