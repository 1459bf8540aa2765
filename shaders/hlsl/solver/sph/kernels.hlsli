// The kernels of SPH's terms in q = r/h, safe at any scale (Muller, Charypar & Gross 2003, eq. 20-22; Monaghan 1992;
// Wendland 1995): polynomials that the host chooses. Where all terms have Wendland's C2, one power of t each.
#ifndef BROOKLET_SPH_KERNELS
#define BROOKLET_SPH_KERNELS

#include "layout.hlsli"

// In h. Nearer than this two particles count as this far apart, where a weight has no end at one point.
static const float LEAST_DISTANCE = 1.0e-3;

// W over its sum on the lattice.
float DensityWeight(float q, SphKernels kernels)
{
    float t = saturate(1.0 - q);
    float s = saturate(1.0 - 2.0 * q);
    float4 c = kernels.density;
    return t * t * t * (c.x + t * (c.y + t * (c.z + t * c.w))) + kernels.density_spline * s * s * s;
}

float PairWeight(float q, float4 c, float inverse, float spline)
{
    float t = saturate(1.0 - q);
    float s = saturate(1.0 - 2.0 * q);
    float finite = t * (c.x + t * (c.y + t * (c.z + t * c.w)));
    return finite + (inverse * t * t + spline * s * s) / max(q, LEAST_DISTANCE);
}

// -W'/q: times the offset from j to i in h it is the kernel's gradient over the particle's own position, negative.
float PressureWeight(float q, SphKernels kernels)
{
    return PairWeight(q, kernels.pressure, kernels.pressure_inverse, kernels.pressure_spline);
}

// Of a difference of velocities in the Laplacian times h^2.
float ViscosityWeight(float q, SphKernels kernels)
{
    return PairWeight(q, kernels.viscosity, kernels.viscosity_inverse, kernels.viscosity_spline);
}

// -W'/q of poly6, but for its factor: the colour field's kernel.
float TensionWeight(float q)
{
    float t = saturate(1.0 - q * q);
    return t * t;
}

#endif
