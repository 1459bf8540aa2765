// What is opaque behind the water, as the plane that touches it in each texel of the thickness: worked out once
// and not for each of the discs that cover the texel.
//
// The plane N . x = c, x relative to the eye, is stored as N and c over |N| times half a spacing, so that w - dot(xyz, x)
// is how many of those x lies before it.
#pragma vertex OpaquePlanesVertex
#pragma fragment OpaquePlanesFragment

#include "normal.hlsli"
#include "layout.hlsli"
#include "../frame/camera.hlsli"

Texture2D<float> scene_depth;
ConstantBuffer<FrameView> view;
ConstantBuffer<SurfaceParams> surface;

struct Varyings
{
    float4 position : SV_Position;
    // Where in the scene's own, larger picture this is.
    [[vk::location(0)]] float2 uv : TEXCOORD0;
};

Varyings OpaquePlanesVertex(uint vertex : SV_VertexID)
{
    float2 corner = CoveringCorner(vertex);
    Varyings output;
    output.position = float4(corner, 0.0, 1.0);
    output.uv = float2(0.5, -0.5) * corner + 0.5;
    return output;
}

// The depth buffer as inverse_depth: reversed depth is near / distance, and 0 where nothing is opaque.
float OpaqueInverseDepthAt(int2 pixel)
{
    return InverseDepthAt(scene_depth, view.size_px, pixel) / view.near_m;
}

float4 OpaquePlanesFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.uv * view.size_px);
    float here = OpaqueInverseDepthAt(pixel);
    // All is before nothing.
    if (here <= 0.0)
        return float4(0.0, 0.0, 0.0, 1.0);
    float same = InverseDepthDifference(surface.range_m, here);
    float along_x = Slope(OpaqueInverseDepthAt(pixel - int2(1, 0)), here, OpaqueInverseDepthAt(pixel + int2(1, 0)), same);
    float along_y = -Slope(OpaqueInverseDepthAt(pixel - int2(0, 1)), here, OpaqueInverseDepthAt(pixel + int2(0, 1)), same);
    float3 plane = PlaneFromSlopes(view, pixel, here, float2(along_x, along_y));
    return float4(plane, 1.0) / (length(plane) * 0.5 * surface.spacing_m);
}
