// Spray, foam and bubbles: diffuse particles after Ihmsen, Akinci, Akinci & Teschner 2012, "Unified spray, foam and bubbles for
// particle-based fluids". They follow the fluid and do nothing to it.
#ifndef BROOKLET_DIFFUSE_LAYOUT
#define BROOKLET_DIFFUSE_LAYOUT

// Shares of the fluid particles that are near one with fluid all around: below the one it is spray, above the other a
// bubble, and foam between. The paper's 6 and 20, of the 33 that lie within h = 2 d.
static const float SPRAY_BELOW = 0.18;
static const float BUBBLE_ABOVE = 0.6;
// How many a fluid particle spawns in a step, at most.
static const uint MOST_SPAWNED = 256;

// One of them. A lifetime of 0 is an empty slot.
struct DiffuseParticle
{
    float3 position_m;
    float lifetime_s;       // that is left
    float3 velocity_m_s;
    float crowd;            // share of the fluid particles that are near one with fluid all around
};

// Their slots, a ring: the oldest are overwritten first.
struct DiffuseState
{
    uint3 groups;           // of PARTICLE_GROUP that visit the slots in use: a VkDispatchIndirectCommand
    uint next_slot;
    uint vertex_count;      // a triangle for each slot in use: a VkDrawIndirectCommand
    uint instance_count;
    uint first_vertex;
    uint first_instance;
};

// What makes and moves them. Each potential is a quantity below the least of which nothing comes of it, and above whose range
// no more: Phi(I, tau_min, tau_max), eq. (1).
struct DiffuseParams
{
    uint capacity;
    float trapped_air_per_s;            // k_ta, eq. (8): of one fluid particle
    float wave_crest_per_s;             // k_wc
    float lifetime_s;
    float trapped_air_least_m_s;
    float trapped_air_inverse_range_s_m;
    float wave_crest_least;
    float wave_crest_inverse_range;
    float energy_least_j_kg;
    float energy_inverse_range_kg_j;
    float buoyancy;                     // k_b, eq. (12): of gravity
    float drag;                         // k_d, likewise: share of the fluid's velocity that a bubble takes on in a step
    float inverse_neighbours;           // over the neighbours of one with fluid all around
    float inverse_weight;               // over the sum of their weights 1 - r/h
    float inverse_normal;               // over the length of a flat surface's normal
    float spread_m;                     // radius of the cylinder in which a fluid particle spawns them: what it keeps from walls
    uint substeps;                      // that a pass stands for
    float along_z;                      // 1; 0 in two dimensions
    float reserved0;
    float reserved1;
};

// How they look.
struct DiffuseStyle
{
    float radius_m;         // of one that is drawn
    float opacity;          // optical depth at the middle of one
    float spacing_m;        // of the fluid: one less than this behind its surface is on it
    float fade_s;           // before the end of its lifetime it fades for so long
};

#endif
