// Bins that grow with the value: bits 18 and up of a float are its exponent and five bits of its
// mantissa, so 32 bins cover an octave. From 2^-14 (below it: bin 0) to 4 (above it: the last).
#ifndef BROOKLET_HISTOGRAM
#define BROOKLET_HISTOGRAM

#include "../shared/layout.hlsli"

static const uint HISTOGRAM_FIRST = 0x38800000u >> 18; // the bits of 2^-14

uint HistogramBin(float value)
{
    uint bits = asuint(value) >> 18;
    return clamp(bits, HISTOGRAM_FIRST, HISTOGRAM_FIRST + HISTOGRAM_BINS - 1) - HISTOGRAM_FIRST;
}

// The middle of a bin; 0 for the first, which holds all that is smaller.
float HistogramValue(uint bin)
{
    return bin == 0 ? 0.0 : asfloat(((HISTOGRAM_FIRST + bin) << 18) + (1u << 17));
}

#endif
