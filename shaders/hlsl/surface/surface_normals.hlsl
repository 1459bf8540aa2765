// The surface's normals as a texture, for who wants them (measuring a filter's error); the water
// itself restores them where it shades. w is 1 on the fluid.
#pragma vertex SurfaceNormalsVertex
#pragma fragment SurfaceNormalsFragment

#include "filter.hlsl"
#include "normal.hlsl"

Varyings SurfaceNormalsVertex(uint vertex : SV_VertexID)
{
    return covering(vertex);
}

float4 SurfaceNormalsFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = inverse_depth_of(pixel);
    if (here <= 0.0)
        return 0.0;
    return float4(normal_at(inverse_depth, view, pixel, here, surface.range_m), 1.0);
}
