// The surface that sunlight meets without the particles' bumps, which would each be a lens: a line
// fitted to the texels of one surface in a Gaussian's window, one direction a pass, several times. A
// plane stays as it is, up to its edge. A mean of what lies to both sides would smooth nothing there, and
// at the outline of a body, which the sun grazes, its particles' bumps would comb the light.
//
// At the walls the water is as flat as they are, and the surface that meets them ends there.
#pragma vertex SmoothSunDepthVertex
#pragma fragment SmoothSunDepthFragment
#pragma multi_compile ALONG_X ALONG_Y

#include "inverse_depth.hlsli"
#include "sun_map.hlsli"
#include "../frame/covering.hlsli"

Texture2D<float> sun_depth;
ConstantBuffer<FrameLight> light;
ConstantBuffer<SurfaceParams> surface;

#if defined(ALONG_Y)
static const int2 ALONG = int2(0, 1);
#else
static const int2 ALONG = int2(1, 0);
#endif

Varyings SmoothSunDepthVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

float4 SmoothSunDepthFragment(Varyings input) : SV_Target0
{
    int2 texel = int2(input.position.xy);
    float here = SunDepthAt(sun_depth, surface, texel);
    if (here <= 0.0)
        return 0.0;
    Entry entry = EntryAt(surface, light, texel);
    if (IsWall(entry, here))
        return entry.depth;
    float spacing_m = PhotonSpacingM(surface, light);
    float reach = min(surface.sun_smoothing_m / spacing_m, surface.most_reach_px);
    // Least squares: sums of w, w i, w i^2, and of w and w i times what is above `here`.
    float3 weights = float3(MIDDLE_WEIGHT, 0.0, 0.0);
    float2 above = 0.0;
    [loop]
    for (int i = -int(reach); i <= int(reach); i++)
    {
        int2 at = texel + i * ALONG;
        float there = SunDepthAt(sun_depth, surface, at);
        float away = float(i);
        if (i != 0 && IsSameSurface(surface, light, here, at, there, i))
        {
            float weight = SpatialWeight(away * away, reach);
            weights += weight * float3(1.0, away, away * away);
            above += weight * (there - here) * float2(1.0, away);
        }
    }
    float spread = weights.x * weights.z - weights.y * weights.y;
    float fit = spread > 0.0 ? (above.x * weights.z - above.y * weights.y) / spread : 0.0;
    return min(here + fit, entry.depth);
}
