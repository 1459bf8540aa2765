// What the fragment stages of all smoothing filters share. They are fragment stages so that the
// depth test (triangle at depth 0, fluid only where the particles wrote more) rejects what no fluid
// covers before a shader runs, in hardware, and a tile-based GPU writes whole compressed tiles.
#ifndef BROOKLET_FILTER
#define BROOKLET_FILTER

#include "layout.hlsl"
#include "inverse_depth.hlsl"
#include "../frame/camera.hlsl"

Texture2D<float> inverse_depth;
ConstantBuffer<FrameView> view;
ConstantBuffer<SurfaceParams> surface;

struct Varyings
{
    float4 position : SV_Position;
};

Varyings covering(uint vertex)
{
    Varyings output;
    output.position = float4(covering_corner(vertex), 0.0, 1.0);
    return output;
}

float inverse_depth_of(int2 pixel)
{
    return inverse_depth_at(inverse_depth, view.size_px, pixel);
}

float reach_of(float here)
{
    return reach_px(surface.smoothing_m, here, view.pixel_angle, surface.most_reach_px);
}

#endif
