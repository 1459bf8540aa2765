// What the host tells the stages that mesh the fluid's surface, and what they tell each other. The rule of
// shared/layout.hlsli holds: no hidden padding. Lengths are metres, relative to the domain's lowest corner.
#ifndef BROOKLET_MESH_LAYOUT
#define BROOKLET_MESH_LAYOUT

// Cells of a block along each axis: a block's 64 points are a group's threads.
static const uint BLOCK_CELLS = 4;
// Blocks along each side of the cube that a group marks.
static const uint MARKED_BLOCKS = 4;
// The field beyond a wall: so far below 0 that the surface is cut at the wall's own point, in f32 exactly.
static const float BEYOND_M = -1.0e15;
// Reach of an ellipsoid's kernel along an axis that is not stretched, in spacings; (1 - q^2)^3 has 64 pi / 315 of its cube.
static const float KERNEL_REACH = 2.5;
// No axis of an ellipsoid with a sphere's volume is stretched further: what is beyond the mesh's reach is not looked at.
static const float KERNEL_STRETCH = 1.3;
// Blocks that a group makes the field of, a thread for two columns of four points each.
static const uint FIELD_BLOCKS = 8;
// What MeshParams::block_entries says of a block that is not listed; of one that is, its place in the list and this much more.
static const uint BLOCK_OUTSIDE = 0;
static const uint BLOCK_INSIDE = 1;
static const uint BLOCK_LISTED = 2;
// The bit of a listed block whose points within the walls are all inside, or all outside.
static const uint BLOCK_UNIFORM = 0x80000000;
// And the bit that says that they are inside.
static const uint BLOCK_UNIFORM_INSIDE = 0x40000000;

// A grid of cells over the domain and one block beyond it on each side, in blocks of 4 x 4 x 4. Walls stand at its
// points. Bins of particles are whole cells wide.
struct MeshParams
{
    float3 min_m;               // of the first block, one block below the domain
    float spacing_m;
    float3 cell_m;              // along each axis: the domain is so many whole cells
    float reach_m;              // of a particle
    uint3 blocks;
    uint block_count;
    uint3 cells;                // of the domain
    uint bin_cells;             // of a bin along each axis
    uint3 bins;
    uint bin_count;
    uint3 low_point;            // the first point that may be inside, along each axis: a wall, or the grid's second
    float radius_m;             // of a particle alone
    uint3 high_point;           // the last one
    float least_weight;
    float3 wall_min_m;          // walls behind which particles are mirrored; too far to matter where there are none
    uint most_blocks;
    float3 wall_max_m;
    uint most_vertices;
    uint3 mark_groups;          // of 4 x 4 x 4 blocks
    uint most_triangles;
};

// A particle's part in an anisotropic field (Yu & Turk 2013, eq. 9): weight (1 - |G (x - center)|^2)^3.
struct MeshKernel
{
    float3 center_m;
    float weight;           // its integral is the particle's volume
    float3 diagonal_per_m;  // of G, symmetric: xx, yy, zz
    float reserved0;
    float3 beside_per_m;    // xy, xz, yz
    float reserved1;
};

struct MeshVertex
{
    float3 position_m;
    float reserved0;
    float3 normal;              // out of the fluid, of length 1
    float reserved1;
};

// What a frame's mesh came to. Its first four numbers are a VkDrawIndirectCommand, each uint3 a
// VkDispatchIndirectCommand.
struct MeshCounts
{
    uint index_count;
    uint instance_count;
    uint first_vertex;
    uint first_instance;
    uint3 block_groups;         // one for each listed block
    uint blocks;                // listed
    uint3 field_groups;         // one for FIELD_BLOCKS of them
    uint lost_blocks;           // that found no place in the list
    uint3 vertex_groups;        // of 64 vertices
    uint lost_triangles;        // that found no place among the triangles, or whose vertices did not
    uint vertices;
    uint triangles;
    uint lost_vertices;         // that found no place among the vertices
    uint reserved0;
};

#endif
