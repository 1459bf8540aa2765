#ifndef FLOCK_MATH_INCLUDED
#define FLOCK_MATH_INCLUDED

#if defined(UNITY_EDITOR_ONLY_KEYWORD)
    // Never reached outside Unity, so it must not stop anybody.
    #include "UnityCG.cginc"
#endif

float3 SafeNormalize(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-12));
}

#endif
