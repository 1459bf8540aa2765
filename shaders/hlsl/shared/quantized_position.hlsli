// Where a particle is during the iterations: fixed-point coordinates modulo four supports, 21 bits
// an axis in 8 bytes. Differences of neighbours wrap to the right value as long as they are closer
// than three supports, so no cell has to be known; a step is 4h / 2^21 = 1.9e-6 h, finer than an
// f32 coordinate 32 h or more from the domain's corner. A gather then moves half the bytes of a
// Position, and integer differences are opposite bit by bit, so pairs push each other equally.
// With RELAXED_PRECISION and HALF_PRECISION packed: pairs see the top 16 bits of an axis, which stand as they are
// subtracted, and in the 16 bits that are left is lambda as f16 where it is gathered, else the five that follow of each axis.
// Iterations so move a particle by what they are asked to: rounded to 16 bits, what is left of each jitters, and a fall ends
// with 1 to 2 % more energy than it has (app/study/FINDINGS.md).
#ifndef BROOKLET_QUANTIZED_POSITION
#define BROOKLET_QUANTIZED_POSITION

#include "layout.hlsli"

// Support radii in one unit of a coordinate: 2^32 units are 4 h.
static const float SUPPORTS_PER_UNIT = 1.0 / 1073741824.0;

// Iterations move no particle further than this, in h: two that were neighbours and part then stay closer
// than three supports. Coordinates of a particle that went on would come round to its other side.
static const float MAX_DISPLACEMENT = 0.999;

#if defined(RELAXED_PRECISION) || defined(HALF_PRECISION)
#define PACKED
#endif

#define QUANTIZED_BITS 21

// From lengths in h to steps of a quantized position, rounded, as 32-bit coordinates.
uint3 FixedPoint(float3 length_h)
{
    float steps_a_support = float(1u << (QUANTIZED_BITS - 2));
    return asuint(int3(round(length_h * steps_a_support))) << (32 - QUANTIZED_BITS);
}

// The coordinates, each in the top bits of 32.
uint3 UnpackCoordinates(uint2 quantized_position)
{
#if defined(PACKED)
    uint2 top = quantized_position;
    return uint3((top.x & 0xffff0000) | ((top.y & 0x7c00) << 1), (top.x << 16) | ((top.y & 0x03e0) << 6),
                 (top.y & 0xffff0000) | ((top.y & 0x001f) << 11));
#else
    // x and z have the top 21 bits of a word each; y's top 11 bits end the first, its next the second.
    return uint3(quantized_position.x & 0xfffff800, (quantized_position.x << 21) | ((quantized_position.y & 0x7ff) << 10), quantized_position.y & 0xfffff800);
#endif
}

uint2 PackCoordinates(uint3 coordinates)
{
#if defined(PACKED)
    return uint2((coordinates.x & 0xffff0000) | (coordinates.y >> 16),
                 (coordinates.z & 0xffff0000) | ((coordinates.x >> 1) & 0x7c00) | ((coordinates.y >> 6) & 0x03e0)
                     | ((coordinates.z >> 11) & 0x001f));
#else
    return uint2((coordinates.x & 0xfffff800) | (coordinates.y >> 21),
                 (coordinates.z & 0xfffff800) | ((coordinates.y >> 10) & 0x7ff));
#endif
}

// The quantized position of a position relative to the domain's corner, in h.
uint2 QuantizePosition(float3 position_h)
{
    float3 part = position_h * 0.25;
    part -= floor(part);
    return PackCoordinates(FixedPoint(part * 4.0));
}

// From x_j to x_i, in h.
float3 Offset(uint3 x_i, uint3 x_j)
{
    // asint, for DXC 1.7 takes float3(int3(...)) of an unsigned difference as unsigned.
    return float3(asint(x_i - x_j)) * SUPPORTS_PER_UNIT;
}

// What pairs subtract: packed coordinates two to a word, as they are stored, others each in the top bits of its own.
#if defined(PACKED)
typedef uint2 PairCoordinates;
#else
typedef uint3 PairCoordinates;
#endif

PairCoordinates CoordinatesForPairs(uint2 quantized_position)
{
#if defined(PACKED)
    return uint2(quantized_position.x, quantized_position.y & 0xffff0000);
#else
    return UnpackCoordinates(quantized_position);
#endif
}

// From x_j to x_i, in the units of SUPPORTS_PER_UNIT: what all pairs have in common is multiplied after their sum.
// Packed, x is off by less than its last bit, for y is below it: as much the other way for the other of the two, so
// that pairs still push each other equally. What stands below z has to be taken away before.
float3 PairOffset(PairCoordinates x_i, PairCoordinates x_j)
{
#if defined(PACKED)
    uint2 difference = x_i - x_j;
    return float3(asint(uint3(difference.x, difference.x << 16, difference.y)));
#else
    return float3(asint(x_i - x_j));
#endif
}

// How far a particle is from a position, in metres: exactly nothing where it has not moved.
float3 DisplacementFrom(float3 position_m, uint2 quantized_position, SmoothingKernelParams kernel)
{
    uint2 start = QuantizePosition(position_m * kernel.inverse_support_per_m);
    return Offset(UnpackCoordinates(quantized_position), UnpackCoordinates(start)) * kernel.support_m;
}

#if defined(PACKED)
// Lambda in the bits that a packed quantized position leaves, for all who read it, its own particle
// too: pairs stay exactly opposite.
uint2 PackLambda(uint2 quantized_position, float lambda)
{
    return uint2(quantized_position.x, (quantized_position.y & 0xffff0000) | f32tof16(lambda));
}

float UnpackLambda(uint2 quantized_position)
{
    return f16tof32(quantized_position.y & 0xffff);
}
#endif

#endif
