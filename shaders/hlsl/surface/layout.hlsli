// What the host tells the stages that make a surface of particles. The rule of shared/layout.hlsli
// holds: no hidden padding. Lengths are metres.
#ifndef BROOKLET_SURFACE_LAYOUT
#define BROOKLET_SURFACE_LAYOUT

// Radius of a drop of spray alone, over that of a particle among others.
static const float SPRAY_RADIUS = 0.42;
// How far a particle's ellipsoid moves to its neighbours' mean (Yu & Turk 2013, lambda of eq. 6).
static const float SMOOTHED_CENTER = 0.9;
// How far the neighbours' mean lies below a particle of a flat surface, over h (at h = 2 d). Moved by
// that too the water would stand half a spacing lower than the particles are.
static const float FLAT_MEAN = 0.2;
// Its longest axis over its shortest (their k_r of eq. 15).
static const float MOST_STRETCH = 4.0;
// Variances of neighbours count as at least this, over h^2: those of particles in one point.
static const float LEAST_VARIANCE = 1.0e-4;

// CountCovered looks at one drawn pixel in so many along either side,
static const uint COVERED_STRIDE = 4;
// and a group of it at so many of those along either side.
static const uint COVERED_GROUP = 8;

// What the ellipsoids are made from: the neighbours within `support_m`.
struct AnisotropyParams
{
    float support_m;
    uint list_chunks;       // room for neighbours a particle, in LIST_CHUNKs
    uint reserved0;
    uint reserved1;
};

// A particle's ellipsoid (surface/ellipsoid.hlsli).
struct Ellipsoid
{
    float3 center_m;
    uint tag;           // of its particle: quarantined ones are not drawn
    uint3 stretch;      // symmetric 3 x 3, over the sphere: six f16
    uint reserved;
};

// A fluid's surface in screen space.
struct SurfaceParams
{
    float3 wall_min_m;          // the walls' bounds: the fluid is cut off outside this box
    float radius_m;             // of a particle's sphere
    float3 wall_max_m;
    float thickness_radius_m;             // radius of the disc on which a particle's volume counts as thickness
    float spacing_m;            // thickness is kept in spacings: f16 then fits any scene's size
    float smoothing_m;          // reach of the smoothing filters, two standard deviations
    float most_reach_px;        // the reach is clamped to this, so that a near camera has an end
    float range_m;              // depths further apart than this are of different surfaces
    float clamp_m;              // what lies behind counts as this far behind (narrow range)
    float flow_m2;              // curvature flow of one iteration: time x diffusivity, one
    float photons;              // a side of the grid that the sun sends its photons through
    float sun_smoothing_m;      // reach of what smooths the surface that they meet
};

// A ray of sunlight that the water bent.
struct Photon
{
    float2 uv;          // where in the sun's map lies what it lights on the floor
    float path_m;       // how much water it went through
    float share;        // of it that entered the water; 0 where there is none
};

// A grid over the sun's map and along its rays, as many cells along each: how much water is nearer the sun.
struct SunVolumeParams
{
    uint cells;                 // along each side
    float spacing_m;
    float cell_m;               // side of a cell across the rays
    float reserved;
};

// A particle's volume in SunVolume's counts: weights are kept to 1/128, and 2^24 particles in one cell fit.
static const uint SUN_VOLUME_UNITS = 128;

// How the water looks: colours in linear light.
struct WaterStyle
{
    float3 absorption_per_m;    // Beer-Lambert
    float refraction;           // gamma: how far what lies behind is displaced, over the thickness
    float3 scatter_color;       // what thick water shows of its own
    float scatter_per_m;
    float roughness;            // of the highlight, GGX
    float3 reflectance;         // of a metal, at normal incidence; water has WATER_F0
};

#endif
