// Where to look when a few samples stand for many.
#ifndef BROOKLET_SAMPLING
#define BROOKLET_SAMPLING

// Sample `index` of `count` on the unit disc, all with the same share of its area (Vogel 1979).
float2 DiscTap(uint index, uint count)
{
    float angle = index * 2.3999632;
    return sqrt((index + 0.5) / count) * float2(cos(angle), sin(angle));
}

// Noise without clumps: neighbouring pixels differ much, a few together average well
// (Jimenez 2014, interleaved gradient noise).
float PixelNoise(float2 pixel)
{
    return frac(52.9829189 * frac(dot(pixel, float2(0.06711056, 0.00583715))));
}

#endif
