// Solids that fluid flows around: what the host tells of each, where it is, and what particles near one know of it.
#ifndef BROOKLET_SOLIDS_LAYOUT
#define BROOKLET_SOLIDS_LAYOUT

// Solids of a scene: a bit each in a block's mask.
static const uint MAX_SOLIDS = 128;
// Words of such a mask.
static const uint SOLID_MASK_WORDS = 4;

// From where on a particle knows of a solid, in h: iterations move it by less than one, and it stays half a spacing from a
// surface, a third of h at most.
static const float CONTACT_REACH = 1.5;

// What a solid's numbers mean (boundary/solids/shapes.hlsli).
static const uint SHAPE_BOX = 0;
static const uint SHAPE_CAPSULE = 1;    // a sphere with half a length of 0
static const uint SHAPE_CYLINDER = 2;
static const uint SHAPE_FIELD = 3;      // distances on a grid (field.hlsli)

// A solid's shape, in its own frame: its middle at the origin, its axis along y.
struct Solid
{
    float3 half_m;          // of a box its sides, of a cylinder (radius, half its length, radius), of a capsule the same
                            // without its ends
    uint shape;
    float3 cavity_min_m;    // what is hollow of it, as a shape of the same kind between these; beyond half_m where it is open
    uint is_hollow;
    float3 cavity_max_m;
    float friction;         // of a contact: share of the normal impulse that acts along it (Coulomb)
    float3 extent_m;        // half the sides of the box around it
    float restitution;      // share of the speed across it that a contact gives back
    uint first_keyframe;    // of its motion
    uint keyframe_count;
    float period_s;         // after which keyframes begin again; 0: they end
    uint body;              // whose reaction it gives: below body_count it is that body, else it moves by its keyframes, and
                            // what pushes it is summed if this is not NO_BODY (boundary/bodies)
    float3 field_min_m;     // lowest node of a field
    float field_cell_m;     // between two of its nodes
    uint3 field_nodes;      // along each side, two or more
    uint first_field_node;  // of all fields' nodes; x goes fastest
};

// Where a solid is at a time; between two it moves evenly, and turns evenly around one axis.
struct Keyframe
{
    float3 position_m;
    float time_s;
    float4 rotation;        // of its frame: a quaternion (x, y, z, w)
};

// Where a solid is at a substep's end, and at its begin.
struct SolidPose
{
    float3 position_m;
    float reserved0;
    float4 rotation;
    float3 before_m;
    float reserved1;
    float4 rotation_before;
    float3 min_m;           // the box around both, and around what is near enough to feel it
    float reserved2;
    float3 max_m;
    float reserved3;
};

// What a particle knows of the solids near it: a half-space that adds as much density as they do, and a plane that it may
// not pass. Both are of the nearest part, and hold for as far as a substep's iterations move it.
struct SolidContact
{
    float3 normal;          // out of the half-space, which is beyond normal * x < offset_m; 0 where none is near
    float offset_m;
    float3 stop_normal;     // out of the nearest solid
    float stop_offset_m;    // of its surface
    uint solid;             // the nearest
    float speed_m_s;        // of the nearest solid there, along `normal`
    uint body;              // of the nearest, or NO_BODY
    uint reserved1;
    float3 taken_m_s;       // change of velocity that iterations gave the particle for solids, which a body gives back
    uint reserved2;
};

// All of them.
struct SolidsParams
{
    uint3 blocks;           // of the domain, each with a mask of the solids near it
    uint solid_count;
    float3 inverse_block_per_m;
    float reach_m;          // from a surface, within which a particle knows of it
    float3 block_m;
    float stop_m;           // particles stay at least this far from a surface
    uint body_count;
    uint point_count;       // of all bodies' surfaces
    float units_per_m_s;    // of a reaction's sum, a particle's change of velocity; 0 where nothing has a reaction
    float unit_kg_m_s;      // the impulse that is one of those
};

#endif
