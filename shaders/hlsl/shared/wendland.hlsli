// Wendland's C2 kernel (Wendland 1995) in q = r/h, scaled to W(0) = 1: W = (1-q)^4 (4q+1).
// Its gradient -20 (1-q)^3 r/h needs no division by r, and its Fourier transform is positive, so
// particles do not pair (Dehnen & Aly 2012). In q, nothing overflows at any scale of the scene.
#ifndef BROOKLET_WENDLAND
#define BROOKLET_WENDLAND

#include "precision.hlsli"

real WendlandW(real q)
{
    real t = saturate(real(1.0) - q);
    real t2 = t * t;
    return t2 * t2 * (real(4.0) * q + real(1.0));
}

// The gradient of W in units of 1/h is this factor times r/h, r pointing from the neighbour here.
real WendlandGradientFactor(real q)
{
    real t = saturate(real(1.0) - q);
    return real(-20.0) * t * t * t;
}

#endif
