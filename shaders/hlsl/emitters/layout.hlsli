// Where particles come from and go to while a scene runs.
#ifndef BROOKLET_EMITTERS_LAYOUT
#define BROOKLET_EMITTERS_LAYOUT

// Emitters of a scene: a thread each.
static const uint MAX_EMITTERS = 64;
// Drains of a scene: each particle looks at all of them.
static const uint MAX_DRAINS = 64;

// What a drain's numbers mean.
static const uint DRAIN_BOX = 0;
static const uint DRAIN_SPHERE = 1;
static const uint DRAIN_OUTSIDE = 2;    // of a box

// A nozzle, which emits a layer of lattice points each time its flow moved a spacing; or a block of them, once.
struct Emitter
{
    float3 direction;       // of the flow, in the nozzle's frame, of length 1
    float speed_m_s;
    uint first_point;       // of a layer, among those of all emitters
    uint points;
    uint first_keyframe;    // of its motion
    uint keyframe_count;
    float period_s;         // after which keyframes begin again; 0: they end
    float start_s;
    float end_s;
    float lifetime_s;       // of a particle; 0: for ever
    float layers_per_m;     // of its flow; 0: one at start_s, and no other
    float jitter_m;         // how far along each axis a particle may be from its lattice point
    uint fluid;
    uint most_layers;       // in a substep
    float3 across;          // along the nozzle's width, of length 1, in its frame
    float half_width_m;     // its radius where it is round
    float3 up;              // along its height, likewise
    float half_height_m;    // 0: it is round
};

// A point of a layer, in the nozzle's frame.
struct EmitterPoint
{
    float3 place_m;
    float reserved;
};

// What lasts of an emitter from substep to substep.
struct EmitterState
{
    float moved;            // by its flow, in spacings, since half a spacing before the last layer; a layer is due at .5
    uint layers;            // so far
    uint reserved0;
    uint reserved1;
};

// What an emitter does in a substep.
struct EmitterFlow
{
    float3 position_m;      // of its frame, when the substep begins
    float ahead_m;          // of the nozzle is its oldest layer
    float4 rotation;
    float3 after_m;         // of its frame, when the substep ends
    uint first;             // of its particles among those of all emitters
    float4 rotation_after;
    uint layers;
    uint layer;             // number of the oldest
    uint flows;             // 1 while it does
    uint reserved;
};

// What all of them do.
struct Emission
{
    uint3 groups;           // of PARTICLE_GROUP that emit: a VkDispatchIndirectCommand
    uint claimed;           // slots
    uint first_slot;
    float time_s;           // when the last substep ended that was opened, as StepState has it
    float time_lost_s;
    uint reserved;
};

struct EmissionParams
{
    uint emitters;
    uint capacity;          // slots there are
    float spacing_m;
    float along_z;          // 1; 0 in two dimensions, where nothing is off the plane
    float guide_m;          // so far before a nozzle particles have its velocity
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

// A region that deactivates what enters.
struct Drain
{
    float3 min_m;           // a sphere's middle
    uint shape;
    float3 max_m;           // a sphere's radius along each axis
    float particles_per_s;  // that it takes at most; of drains without a limit 0
};

struct DrainParams
{
    uint drains;
    uint counts_ages;       // 1 where no other stage of the solver counts them
    uint reserved0;
    uint reserved1;
};

// Of a drain with a limit: what it may still take.
struct DrainState
{
    float credit;           // particles
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

#endif
