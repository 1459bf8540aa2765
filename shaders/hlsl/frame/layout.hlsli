// What the host tells the drawing stages. The rule of shared/layout.hlsli holds: every field is
// placed alike in a uniform and in a structured buffer, with no hidden padding.
// Lengths are metres, relative to the domain's lowest corner; y is up. "World" is that frame.
#ifndef BROOKLET_FRAME_LAYOUT
#define BROOKLET_FRAME_LAYOUT

// The camera: where it stands, its axes, and how wide it sees. Depth is reversed with the far
// plane at infinity: depth = near_m / distance along `forward`.
struct FrameView
{
    float3 eye_m;
    float near_m;
    float3 right;
    float tan_half_width;
    float3 up;
    float tan_half_height;
    float3 forward;
    float pixel_angle;      // how far apart two drawn pixels are at distance 1
    float2 size_px;         // of the drawn (supersampled) picture
    float supersample;      // drawn pixels a side of one picture pixel
    float reserved;
};

// The sun and its shadow map: a parallel projection along the sun's rays.
struct FrameLight
{
    float3 to_sun;
    float shadow_range_m;   // metres along the rays over which shadow depth goes from 1 to 0
    float3 sun_color;
    float shadow_texels;    // side of the shadow map
    float4 shadow_u;        // dot(xyz, p) + w: column in 0..1
    float4 shadow_v;        // row in 0..1
    float4 shadow_depth;    // 1 nearest the sun, 0 farthest
    float3 sky_zenith;
    float shadow_texel_m;
    float3 sky_horizon;
    float exposure;
};

// What is drawn and how it looks.
struct FrameStyle
{
    float3 domain_size_m;
    float tile_m;                   // side of a floor tile
    float3 floor_color;
    float floor_fade_m;             // distance over which the floor melts into the horizon
    float radius_m;                 // of a drawn particle
    float inverse_speed_scale_s_m;  // 1 / the speed that is drawn as foam
    float light_depth_m;            // how deep the sun reaches into the fluid
    float edge_width_px;            // of the domain's lines, in picture pixels
    float3 edge_color;
    float edge_opacity;
    float occlusion_m;              // reach of the ambient occlusion
    float occlusion_strength;
    float2 reserved;
};

// How much of one picture shows over another.
struct CrossFadeParams
{
    float opacity;
    float3 reserved;
};

// A corner of a solid's triangles, in the solid's own frame.
struct SolidVertex
{
    float3 position_m;
    uint solid;             // of the scene's
    float3 normal;          // out of what is solid, into a cavity
    float rim;              // 1 where a hollow one's wall ends, which shows its thickness; of ground its share of the
                            // other color
};

// What a solid looks like.
struct SolidPaint
{
    float3 color;           // of its surface, in linear light
    float gloss;            // share of what smooth paint mirrors
    float3 other;           // the same where `rim` is 1
    float reserved;
};

#endif
