// What the host tells the stages that make a surface of particles. The rule of shared/layout.hlsl
// holds: no hidden padding. Lengths are metres.
#ifndef BROOKLET_SURFACE_LAYOUT
#define BROOKLET_SURFACE_LAYOUT

// A fluid's surface in screen space.
struct SurfaceParams
{
    float3 box_min_m;           // the fluid is cut off outside this box: at a tank's glass
    float radius_m;             // of a particle's sphere
    float3 box_max_m;
    float spread_m;             // radius of the disc on which a particle's volume counts as thickness
    float spacing_m;            // thickness is kept in spacings: f16 then fits any scene's size
    float smoothing_m;          // reach of the smoothing filters, two standard deviations
    float most_reach_px;        // the reach is clamped to this, so that a near camera has an end
    float range_m;              // depths further apart than this are of different surfaces
    float clamp_m;              // what lies behind counts as this far behind (narrow range)
    float flow_m2;              // curvature flow of one iteration: time x diffusivity, one
    float2 reserved;
};

// How the water looks: colours in linear light.
struct WaterStyle
{
    float3 absorption_per_m;    // Beer-Lambert
    float refraction;           // gamma: how far what lies behind is displaced, over the thickness
    float3 scatter_color;       // what thick water shows of its own
    float scatter_per_m;
    float roughness;            // of the highlight, GGX
    float ripple;               // share of the floor's brightness that the caustics move
    float caustic_texels;       // side of the caustics' map
    float caustic_margin_m;     // the map reaches so far beyond the domain
};

#endif
