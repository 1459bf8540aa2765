// The bilateral filter (Tomasi & Manduchi 1998) over the fluid's pixels: near in the picture and
// near in depth counts much. It is not separable; one direction after the other is the usual
// approximation, and FILTER_PLANE is the filter itself.
#pragma vertex SmoothBilateralVertex
#pragma fragment SmoothBilateralFragment
#pragma multi_compile FILTER_X FILTER_Y FILTER_PLANE

#include "filter.hlsli"

Varyings SmoothBilateralVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

float4 SmoothBilateralFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = InverseDepthOf(pixel);
    if (here <= 0.0)
        return 0.0;
    float reach = ReachOf(here);
    float inverse_range = 1.0 / InverseDepthDifference(surface.range_m, here);
    float sum = MIDDLE_WEIGHT * here;
    float weights = MIDDLE_WEIGHT;
    int most = int(reach);
#if defined(FILTER_PLANE)
    [loop]
    for (int y = -most; y <= most; y++)
        [loop]
        for (int x = -most; x <= most; x++)
        {
            int squared_px = x * x + y * y;
            if (squared_px == 0 || float(squared_px) > reach * reach)
                continue;
            int2 there_px = pixel + int2(x, y);
            float squared = float(squared_px);
#else
    [loop]
    for (int i = -most; i <= most; i++)
        {
            if (i == 0)
                continue;
#if defined(FILTER_Y)
            int2 there_px = pixel + int2(0, i);
#else
            int2 there_px = pixel + int2(i, 0);
#endif
            float squared = float(i * i);
#endif
            float there = InverseDepthOf(there_px);
            float apart = (there - here) * inverse_range;
            float weight = there > 0.0 ? SpatialWeight(squared, reach) * exp(-0.5 * apart * apart) : 0.0;
            sum += weight * there;
            weights += weight;
        }
    return sum / weights;
}
