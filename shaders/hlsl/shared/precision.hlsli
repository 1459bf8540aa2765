// The type of what is computed for each pair of particles out of their distance (wendland.hlsli). Positions are
// subtracted before, in integers, and vectors and sums are f32: only what lies between is lowered. A vector in f16 is
// no less work where its sum is f32, for each component is converted and then added, not multiplied and added at once.
// RELAXED_PRECISION is a hint that a driver may take for f16 or leave (Adreno's take it);
// HALF_PRECISION is f16 indeed: what the hint may do at worst.
#ifndef BROOKLET_PRECISION
#define BROOKLET_PRECISION

#if defined(HALF_PRECISION)
typedef float16_t real;
#elif defined(RELAXED_PRECISION)
typedef min16float real;
#else
typedef float real;
#endif

#endif
