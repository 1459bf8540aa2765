// Where what moves by keyframes is at a time. Between two keyframes it moves evenly and turns evenly around one axis (a
// quaternion's slerp), no more than a quarter of a turn; before the first and behind the last it stands, or begins again.
// `keyframes` stands before it.
#ifndef BROOKLET_MOTION
#define BROOKLET_MOTION

#include "layout.hlsli"

// sin(share a) / sin(a) of an angle a with this cosine, up to 45 degrees within 1e-7: a series of products (Eberly 2011), for
// Vulkan's sine may be off by 5e-4.
float PartOfTurn(float share, float cosine)
{
    float sum = 1.0;
    [loop]
    for (uint k = 7; k > 0; --k)
    {
        float n = float(k);
        sum = 1.0 + (share * share / (n * (2.0 * n + 1.0)) - n / (2.0 * n + 1.0)) * (cosine - 1.0) * sum;
    }
    return share * sum;
}

// The rotation a share of the way from one to another, at most a quarter of a turn.
float4 Slerp(float4 from, float4 to, float share)
{
    float cosine = dot(from, to);
    return normalize(PartOfTurn(1.0 - share, cosine) * from + PartOfTurn(share, cosine) * to);
}

// By `count` keyframes from `first` on, which begin again after `period_s` where that is not 0.
Keyframe PoseAt(uint first, uint count, float period_s, float time_s)
{
    uint last = first + count - 1;
    if (period_s > 0.0)
        time_s -= period_s * floor(time_s / period_s);
    uint next = first;
    while (next < last && keyframes[next].time_s <= time_s)
        ++next;
    Keyframe to = keyframes[next];
    Keyframe from = keyframes[max(next, first + 1) - 1];
    float share = saturate((time_s - from.time_s) / max(to.time_s - from.time_s, 1.0e-30));
    Keyframe pose;
    pose.time_s = time_s;
    pose.position_m = from.position_m + share * (to.position_m - from.position_m);
    pose.rotation = Slerp(from.rotation, to.rotation, share);
    return pose;
}

#endif
