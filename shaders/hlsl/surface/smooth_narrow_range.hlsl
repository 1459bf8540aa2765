// The narrow-range filter (Truong & Yuksel 2018): a Gaussian that passes over what lies in front
// (with its mirror image, so that nothing leans to one side), takes what lies behind as a little
// behind, and widens the range as it goes along a slope. One direction a pass; FILTER_PLANE is the small
// filter of two dimensions that takes away the streaks of both.
#pragma vertex SmoothNarrowRangeVertex
#pragma fragment SmoothNarrowRangeFragment
#pragma multi_compile FILTER_X FILTER_Y FILTER_PLANE

#include "filter.hlsli"

// Pixels that FILTER_PLANE reaches.
static const int PLANE_PX = 4;

Varyings SmoothNarrowRangeVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

struct Range
{
    float low;
    float high;
    float step;     // by how much a found depth widens the range
    float behind;   // what lies behind counts as this
    float sum;
    float weights;
};

void TakePair(inout Range range, float before, float after, float weight)
{
    if (max(before, after) > range.high)
        return;
    bool before_behind = before < range.low;
    bool after_behind = after < range.low;
    if (!before_behind)
    {
        range.low = min(range.low, before - range.step);
        range.high = max(range.high, before + range.step);
    }
    if (!after_behind)
    {
        range.low = min(range.low, after - range.step);
        range.high = max(range.high, after + range.step);
    }
    range.sum += weight * ((before_behind ? range.behind : before) + (after_behind ? range.behind : after));
    range.weights += 2.0 * weight;
}

float4 SmoothNarrowRangeFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = InverseDepthOf(pixel);
    if (here <= 0.0)
        return 0.0;
    float reach = ReachOf(here);
    Range range;
    range.step = InverseDepthDifference(surface.range_m, here);
    range.low = here - range.step;
    range.high = here + range.step;
    range.behind = here - InverseDepthDifference(surface.clamp_m, here);
    range.sum = MIDDLE_WEIGHT * here;
    range.weights = MIDDLE_WEIGHT;
#if defined(FILTER_PLANE)
    float small_reach = min(reach, float(PLANE_PX));
    if (small_reach < 1.0)
        return here;
    [unroll]
    for (int y = 0; y <= PLANE_PX; y++)
        [unroll]
        for (int x = -PLANE_PX; x <= PLANE_PX; x++)
            // Half of the plane, and its mirror image.
            if (y > 0 || x > 0)
            {
                int2 aside = int2(x, y);
                TakePair(range, InverseDepthOf(pixel - aside), InverseDepthOf(pixel + aside),
                          SpatialWeight(float(x * x + y * y), small_reach + 1.0));
            }
#else
#if defined(FILTER_Y)
    const int2 along = int2(0, 1);
#else
    const int2 along = int2(1, 0);
#endif
    [loop]
    for (int i = 1; i <= int(reach); i++)
        TakePair(range, InverseDepthOf(pixel - i * along), InverseDepthOf(pixel + i * along),
                  SpatialWeight(float(i * i), reach));
#endif
    return range.sum / range.weights;
}
