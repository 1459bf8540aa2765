// Solids that the fluid moves: what the host tells of each, and how it moves.
#ifndef BROOKLET_BODIES_LAYOUT
#define BROOKLET_BODIES_LAYOUT

// Bodies of a scene: a thread each of one group.
static const uint MAX_BODIES = 64;
// The number of what is no body.
static const uint NO_BODY = 4294967295;
// What a point of a body's surface touches, at most.
static const uint CONTACTS_PER_POINT = 4;
// Words of a body's reaction: three components of an impulse, three of its moment, 64 bits each, low words first; then how
// many times particles pushed. Those of bodies come first, and are taken by step_bodies; then those of solids whose force is
// measured, about the domain's corner, which nobody takes.
static const uint REACTION_WORDS = 16;

// A body: the solid that it is, its inertia, and what holds it.
struct RigidBody
{
    float3 centre_of_mass_m;        // in its solid's frame
    float inverse_mass_per_kg;
    float3 inertia_kg_m2;           // about that, in the frame: xx, yy, zz
    float added_mass_kg;            // of fluid that it takes along where it is all wet
    float3 products_kg_m2;          // of the same tensor: xy, yz, zx
    float wet_per_push;             // share of its surface that one particle wets
    float3 added_inertia_kg_m2;     // of the fluid that it takes along
    uint solid;
    float3 added_products_kg_m2;
    float hinge_inertia_kg_m2;      // about its hinge; 0 of a body that is free
    float3 hinge_m;                 // a place on its hinge
    float hinge_added_kg_m2;        // of fluid, about the hinge
    float3 hinge_axis;              // as long as 1
    float reserved0;
    float3 hinge_place_m;           // that place in the frame
    float reserved1;
};

// How a body moves; of a solid whose force is measured all of it 0.
struct BodyState
{
    float3 position_m;              // of its centre of mass
    float reserved0;
    float4 rotation;                // of its frame: a quaternion (x, y, z, w)
    float3 velocity_m_s;
    float reserved1;
    float3 spin_rad_s;
    float reserved2;
    float3 owed_kg_m_s;             // what the fluid gave and it has not taken yet (boundary/bodies/step_bodies.compute)
    float reserved3;
    float3 owed_kg_m2_s;            // the same of angular momentum
    float reserved4;
};

// A ball on a body's surface, in its solid's frame: what it touches others with.
struct SurfacePoint
{
    float3 place_m;
    float radius_m;
    uint body;
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

// What a surface point touches.
struct BodyContact
{
    float3 at_m;                    // on the other's surface
    float gap_m;                    // between the two; negative where one is in the other
    float3 normal;                  // towards the body
    uint body;                      // NO_BODY: no contact
    float3 other_m_s;               // of what is no body
    uint other;                     // body; NO_BODY of walls and of solids that move as they are told
    float friction;
    float restitution;
    float reserved0;
    float reserved1;
};

// Which body is dragged, by which of its points and to where (boundary/bodies/drag_body.compute).
struct BodyDragParams
{
    float3 grip_m;                  // in its solid's frame
    uint body;                      // NO_BODY: none is
    float3 target_m;                // where the grip is drawn to
    float kept;                     // share of the grip's velocity that is left of it
    float pull_per_s;               // of the way to the target
    float kept_spin;                // share of the body's spin that is left of it
    float most_m_s;                 // the grip is made no faster
    uint reserved0;
};

#endif
