// The type of what is computed for each pair of particles. Positions are subtracted before, in
// integers, and sums are kept after, in f32: only what lies between is lowered.
// RELAXED_PRECISION is a hint that a driver may take for f16 or leave (Adreno's take it);
// HALF_PRECISION is f16 indeed: what the hint may do at worst.
#ifndef BROOKLET_PRECISION
#define BROOKLET_PRECISION

#if defined(HALF_PRECISION)
typedef float16_t real;
typedef vector<float16_t, 3> real3;
#elif defined(RELAXED_PRECISION)
typedef min16float real;
typedef min16float3 real3;
#else
typedef float real;
typedef float3 real3;
#endif

#endif
