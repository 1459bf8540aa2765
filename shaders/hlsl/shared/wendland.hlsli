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

// What pairs compute, out of t = 1 - q: products of one number, of which f16 loses little, and its vectors are left to
// f32, which multiplies and adds them in one instruction. The gradient of W in units of 1/h is WENDLAND_GRADIENT t^3 r/h.
static const float WENDLAND_GRADIENT = -20.0;

struct WendlandPair
{
    real t;
    real t_squared;
    float t_cubed;
};

// Of two particles that far apart in units of which `supports_per_unit` make h.
WendlandPair WendlandOf(float units, float supports_per_unit)
{
    WendlandPair pair;
    pair.t = real(saturate(1.0 - units * supports_per_unit));
    pair.t_squared = pair.t * pair.t;
    pair.t_cubed = float(pair.t_squared * pair.t);
    return pair;
}

float WendlandW(WendlandPair pair)
{
    return float(pair.t_squared * pair.t_squared * (real(5.0) - real(4.0) * pair.t));
}

#endif
