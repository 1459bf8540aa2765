// From linear light to the picture: ambient occlusion from the depth (of points), tone mapping of
// every drawn pixel, their mean, sRGB, and a dither of one step against banding.
#pragma vertex ResolveVertex
#pragma fragment ResolveFragment
#pragma multi_compile _ WATER

#include "covering.hlsli"
#include "sampling.hlsli"

Texture2D<float4> radiance;
#if defined(WATER)
Texture2D<float4> water;    // premultiplied; alpha is 1 where water is seen
#else
Texture2D<float> depth_map;
#endif
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;

Varyings ResolveVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

#if !defined(WATER)
float DistanceAt(float2 drawn_px)
{
    int2 at = int2(clamp(drawn_px, 0.0, view.size_px - 1.0));
    return view.near_m / max(depth_map.Load(int3(at, 0)), 1e-7);
}

// How much of the sky a pixel does not see, from the depths around it: each tap counts by how far
// it stands in front, and not at all when it is so far in front that it is another thing.
float Occlusion(float2 drawn_px, float distance_m)
{
    float reach_px = style.occlusion_m / (distance_m * view.pixel_angle);
    if (reach_px < 1.0)
        return 0.0;
    reach_px = min(reach_px, 48.0 * view.supersample);
    float turn = 6.2831853 * PixelNoise(drawn_px);
    float2x2 turned = float2x2(cos(turn), -sin(turn), sin(turn), cos(turn));
    float limit = style.occlusion_m;
    const uint taps = 14;
    float sum = 0.0;
    float all = 0.0;
    [unroll]
    for (uint i = 0; i < taps; i++)
    {
        float2 tap = DiscTap(i, taps);
        float2 aside = reach_px * mul(turned, tap);
        // Pairs of opposite taps: on a tilted plane what one gains the other loses.
        float front = distance_m - DistanceAt(drawn_px + aside);
        float back = distance_m - DistanceAt(drawn_px - aside);
        float gain = clamp(front, -limit, limit) + clamp(back, -limit, limit);
        float known = saturate(2.0 - 0.5 * max(front, back) / limit);
        // Far taps count less: what they find is shared by all pixels around.
        float weight = 1.2 - length(tap);
        sum += weight * known * saturate(gain / limit);
        all += weight;
    }
    return sum / all;
}
#endif

// A film's curve: Narkowicz 2016, a fit to the ACES reference.
float3 Film(float3 x)
{
    return saturate((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14));
}

float3 SrgbEncode(float3 linear_light)
{
    float3 low = linear_light * 12.92;
    float3 high = 1.055 * pow(max(linear_light, 1e-6), 1.0 / 2.4) - 0.055;
    return lerp(high, low, step(linear_light, 0.0031308));
}

float4 ResolveFragment(Varyings input) : SV_Target0
{
    uint side = uint(view.supersample + 0.5);
    int2 corner = int2(input.position.xy) * int(side);
    float3 sum = 0.0;
#if !defined(WATER)
    float nearest = 0.0;
#endif
    [loop]
    for (uint i = 0; i < side * side; i++)
    {
        int3 at = int3(corner + int2(i % side, i / side), 0);
#if defined(WATER)
        float4 seen = water.Load(at);
        // An edge before water that something opaque hides is all there is: it lies over the scene.
        if (seen.a < 1.0)
            seen.rgb += (1.0 - seen.a) * radiance.Load(at).rgb;
#else
        float4 seen = radiance.Load(at);
        nearest = max(nearest, depth_map.Load(at));
#endif
        // Each drawn pixel by itself: a highlight must not outshine its pixel's other parts.
        sum += Film(seen.rgb * light.exposure);
    }
    float3 color = sum / float(side * side);
#if !defined(WATER)
    if (nearest > 0.0)
    {
        float occluded = Occlusion(float2(corner) + 0.5 * view.supersample, view.near_m / nearest);
        color *= 1.0 - style.occlusion_strength * occluded;
    }
#endif
    float2 ndc = input.position.xy * view.supersample / view.size_px * 2.0 - 1.0;
    color *= 1.0 - 0.10 * dot(ndc, ndc) * 0.5;
    float3 encoded = SrgbEncode(color) + (PixelNoise(input.position.xy) - 0.5) / 255.0;
    return float4(encoded, 1.0);
}
