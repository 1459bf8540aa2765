// What the host tells the stages that mesh the fluid's surface, and what they tell each other. The rule of
// shared/layout.hlsli holds: no hidden padding. Lengths are metres, relative to the domain's lowest corner.
#ifndef BROOKLET_MESH_LAYOUT
#define BROOKLET_MESH_LAYOUT

// Cells of a block along each axis: a block's 64 points are a group's threads.
static const uint BLOCK_CELLS = 4;
// What MeshParams::block_entries says of a block that is not listed; of one that is, its place in the list and this much more.
static const uint BLOCK_OUTSIDE = 0;
static const uint BLOCK_INSIDE = 1;
static const uint BLOCK_LISTED = 2;
// The bit of a listed block whose field is the same at all of its points.
static const uint BLOCK_UNIFORM = 0x80000000;
// And the bit that says that it is inside there.
static const uint BLOCK_UNIFORM_INSIDE = 0x40000000;
// Particles of a block's bin from which on the bin counts as full of fluid: at rest it has 8.
static const uint BIN_FULL = 5;

// A grid of cells over the domain and one block beyond it on each side, in blocks of 4 x 4 x 4; a bin of particles for
// each block within the domain.
struct MeshParams
{
    float3 min_m;               // of the first block, one block below the domain
    float cell_m;
    uint3 blocks;
    uint block_count;
    float3 wall_min_m;          // the walls' bounds: the fluid is cut off there; too far to matter without
    float spacing_m;
    float3 wall_max_m;
    float reach_m;              // of a particle: REACH_RATIO spacings, at most a block's side
    uint3 bins;                 // blocks less 2 along each axis
    float radius_m;             // of a particle alone
    uint most_blocks;
    uint most_vertices;
    uint most_triangles;
    float least_weight;
};

// Field and its gradient at a point: above 0 inside.
struct FieldPoint
{
    float3 gradient;
    float field_m;
};

struct MeshVertex
{
    float3 position_m;
    float reserved0;
    float3 normal;              // out of the fluid, of length 1
    float reserved1;
};

// What a frame's mesh came to. Its first four numbers are a VkDrawIndirectCommand, the next three a
// VkDispatchIndirectCommand with a group for each listed block.
struct MeshCounts
{
    uint index_count;
    uint instance_count;
    uint first_vertex;
    uint first_instance;
    uint3 block_groups;
    uint blocks;                // listed
    uint vertices;
    uint triangles;
    uint lost_blocks;           // that found no place in the list
    uint lost_triangles;        // that found no place among the triangles, or whose vertices did not
};

#endif
