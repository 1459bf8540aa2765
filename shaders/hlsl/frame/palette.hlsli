// Colours of the fluid, linear light.
#ifndef BROOKLET_PALETTE
#define BROOKLET_PALETTE

// Deep water at rest, through azure, to foam: `t` is speed over the speed that foams.
float3 SpeedColor(float t)
{
    const float3 deep = float3(0.006, 0.050, 0.190);
    const float3 blue = float3(0.012, 0.145, 0.440);
    const float3 azure = float3(0.045, 0.370, 0.700);
    const float3 pale = float3(0.300, 0.640, 0.800);
    const float3 foam = float3(0.740, 0.830, 0.860);
    t = saturate(t);
    float3 color = lerp(deep, blue, smoothstep(0.0, 0.25, t));
    color = lerp(color, azure, smoothstep(0.18, 0.55, t));
    color = lerp(color, pale, smoothstep(0.45, 0.80, t));
    return lerp(color, foam, smoothstep(0.72, 1.0, t));
}

// From deep blue at half the rest density over white at it to deep red at a tenth above: compression
// is what a solver is judged by, and a free surface is always below.
float3 DensityColor(float ratio)
{
    const float3 thin = float3(0.010, 0.070, 0.280);
    const float3 rest = float3(0.700, 0.700, 0.680);
    const float3 pressed = float3(0.480, 0.012, 0.010);
    float3 below = lerp(rest, thin, saturate((1.0 - ratio) / 0.5));
    return ratio < 1.0 ? below : lerp(rest, pressed, saturate((ratio - 1.0) / 0.1));
}

// One colour for each fluid, well apart also for colour-blind eyes (after Okabe & Ito 2008).
float3 FluidColor(uint fluid)
{
    switch (fluid % 6u)
    {
        case 0: return float3(0.010, 0.160, 0.450);     // blue
        case 1: return float3(0.790, 0.320, 0.030);     // orange
        case 2: return float3(0.010, 0.340, 0.180);     // green
        case 3: return float3(0.600, 0.190, 0.390);     // purple
        case 4: return float3(0.850, 0.680, 0.080);     // yellow
        default: return float3(0.090, 0.450, 0.780);    // sky blue
    }
}

#endif
