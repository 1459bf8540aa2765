// The surface that sunlight meets without the particles' bumps, which would each be a lens: a Gaussian,
// one direction a pass, over pairs of opposite texels that lie on one surface. In pairs a plane
// stays as it is, however the sun stands to it, up to its edge.
#pragma vertex SmoothSunDepthVertex
#pragma fragment SmoothSunDepthFragment
#pragma multi_compile ALONG_X ALONG_Y

#include "inverse_depth.hlsli"
#include "sun_map.hlsli"
#include "../frame/camera.hlsli"

Texture2D<float> sun_depth;
ConstantBuffer<FrameLight> light;
ConstantBuffer<SurfaceParams> surface;

#if defined(ALONG_Y)
static const int2 ALONG = int2(0, 1);
#else
static const int2 ALONG = int2(1, 0);
#endif

struct Varyings
{
    float4 position : SV_Position;
};

Varyings SmoothSunDepthVertex(uint vertex : SV_VertexID)
{
    Varyings output;
    output.position = float4(CoveringCorner(vertex), 0.0, 1.0);
    return output;
}

float4 SmoothSunDepthFragment(Varyings input) : SV_Target0
{
    int2 texel = int2(input.position.xy);
    float here = SunDepthAt(sun_depth, surface, texel);
    if (here <= 0.0)
        return 0.0;
    float spacing_m = PhotonSpacingM(surface, light);
    float reach = min(surface.sun_smoothing_m / spacing_m, surface.most_reach_px);
    float sum = MIDDLE_WEIGHT * here;
    float weights = MIDDLE_WEIGHT;
    [loop]
    for (int i = 1; i <= int(reach); i++)
    {
        float before = SunDepthAt(sun_depth, surface, texel - i * ALONG);
        float after = SunDepthAt(sun_depth, surface, texel + i * ALONG);
        // A surface may fall by twice what it goes aside: the sun seldom stands lower.
        float range = (surface.range_m + 2.0 * float(i) * spacing_m) / light.shadow_range_m;
        if (min(before, after) > 0.0 && max(abs(before - here), abs(after - here)) < range)
        {
            float weight = SpatialWeight(float(i * i), reach);
            sum += weight * (before + after);
            weights += 2.0 * weight;
        }
    }
    return sum / weights;
}
