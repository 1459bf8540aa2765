// A plain Gaussian over the fluid's pixels, one direction a pass: the baseline. It runs near
// surfaces into far ones.
#pragma vertex SmoothGaussianVertex
#pragma fragment SmoothGaussianFragment
#pragma multi_compile ALONG_X ALONG_Y

#include "filter.hlsli"

#if defined(ALONG_Y)
static const int2 ALONG = int2(0, 1);
#else
static const int2 ALONG = int2(1, 0);
#endif

Varyings SmoothGaussianVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

float4 SmoothGaussianFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = InverseDepthOf(pixel);
    if (here <= 0.0)
        return 0.0;
    float reach = ReachOf(here);
    float sum = MIDDLE_WEIGHT * here;
    float weights = MIDDLE_WEIGHT;
    [loop]
    for (int i = 1; i <= int(reach); i++)
    {
        float weight = SpatialWeight(float(i * i), reach);
        float before = InverseDepthOf(pixel - i * ALONG);
        float after = InverseDepthOf(pixel + i * ALONG);
        sum += weight * (before + after);
        weights += weight * (float(before > 0.0) + float(after > 0.0));
    }
    return sum / weights;
}
