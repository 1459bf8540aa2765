// What the fragment stages of all smoothing filters share. They are fragment stages so that the
// depth test (triangle at depth 0, fluid only where the particles wrote more) rejects what no fluid
// covers before a shader runs, in hardware, and a tile-based GPU writes whole compressed tiles.
#ifndef BROOKLET_FILTER
#define BROOKLET_FILTER

#include "layout.hlsli"
#include "inverse_depth.hlsli"
#include "../frame/covering.hlsli"

Texture2D<float> inverse_depth;
ConstantBuffer<FrameView> view;
ConstantBuffer<SurfaceParams> surface;

float InverseDepthOf(int2 pixel)
{
    return InverseDepthAt(inverse_depth, view.size_px, pixel);
}

float ReachOf(float here)
{
    return ReachPx(surface.smoothing_m, here, view.pixel_angle, surface.most_reach_px);
}

#endif
