// The surface's normals as a texture, for who wants them (measuring a filter's error); the water
// itself restores them where it shades. w is 1 on the fluid.
#pragma vertex SurfaceNormalsVertex
#pragma fragment SurfaceNormalsFragment

#include "filter.hlsli"
#include "normal.hlsli"

Varyings SurfaceNormalsVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

float4 SurfaceNormalsFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = InverseDepthOf(pixel);
    if (here <= 0.0)
        return 0.0;
    return float4(NormalAt(inverse_depth, view, pixel, here, surface.range_m), 1.0);
}
