// The only structs and numbers that the host sees. Every field is placed alike in a uniform and in a
// structured buffer, with no hidden padding: the shader compiler refuses anything else.
// Lengths are metres, relative to the domain's lowest corner; y is up.
#ifndef BROOKLET_LAYOUT
#define BROOKLET_LAYOUT

// Vulkan promises 65,535 groups an axis only, so longer dispatches are folded into rows of so many.
static const uint GROUPS_PER_ROW = 32768;
// Values each thread of a scan takes.
static const uint SCAN_ITEMS = 16;
// Particles whose neighbour lists lie interleaved: a group.
static const uint LIST_SLICE = 64;
// Neighbours of a particle that lie side by side: one 8-byte load.
static const uint LIST_CHUNK = 4;
// A neighbour's delta that stands for nobody, and how far it moves on: half of what 16 bits hold, so that a row of
// candidates that begins within it ends within 16 bits.
static const uint LIST_ESCAPE = 0;
static const uint LIST_ESCAPE_DELTA = 32768;
// Candidates that a search for neighbours looks at, at most: forty times those of fluid at rest. With all
// particles in one cell it would take their number squared, which no driver's watchdog waits for.
static const uint MAX_CANDIDATES = 2048;
// Bins of a histogram, 32 to an octave.
static const uint HISTOGRAM_BINS = 512;
// The bit of Position::tag that parks a particle whose state is not finite.
static const uint QUARANTINED = 0x80000000;
// Where the fluid's number begins in Position::tag; the id lies below.
static const uint FLUID_SHIFT = 24;
// The fluid's number that says that a slot is inactive.
static const uint INACTIVE_FLUID = 127;

// A particle where it is, and which one it is.
struct Position
{
    float3 position_m;
    uint tag;           // bits 0-23 id, 24-30 fluid (127: an inactive slot), 31 quarantined
};

// A particle's quantized position (shared/quantized_position.hlsli) during an iteration, with its constraint's lambda.
struct PositionLambda
{
    uint2 quantized_position;
    float lambda;    // Macklin & Muller 2013, eq. (11), times h^2: no unit
    float total;     // of the lambdas before it, where they accumulate
};

struct Velocity
{
    float3 velocity_m_s;
    float age_s;        // since the particle began, where the solver counts it; below 0: what is left of its lifetime
};

// Curl of the velocity field and its length, 1/s.
struct Vorticity
{
    float3 vorticity_per_s;
    float magnitude_per_s;
};

// Where the counting sort puts a particle: its cell, and how many came before it in that cell.
struct CellSlot
{
    uint cell;
    uint rank;
};

// How a particle's neighbour list begins (shared/list.hlsli).
struct ListHead
{
    uint entries;   // neighbours, and deltas too wide for one
    uint first;     // sorted index that the first neighbour's delta is counted from, plus 1
};

// One substep.
struct StepParams
{
    float3 gravity_m_s2;
    float dt_s;             // that substeps are to take: StepState has the one they take
    float3 domain_size_m;
    float wall_offset_m;    // particles stay at least this far from a wall
    float3 wall_min_m;      // where walls stand; too far to matter along axes that have none
    float max_speed_m_s;
    float3 wall_max_m;
    uint mirrors;           // whether walls count as the solver counts them: 1 as mirrors, 0 by their wall-weight function
    float3 period_m;        // the domain's side along axes that are periodic, 0 along others
    uint list_chunks;       // room for neighbours a particle, in LIST_CHUNKs
    float3 inverse_period_per_m;    // 0 along axes that are not
    uint reserved1;
};

// What only the GPU may know of a substep; the host uploads it with particles alone. What is visited in a
// dispatch or a draw whose size the host does not know is said in the form of Vulkan's indirect commands.
struct StepState
{
    uint slot_count;        // slots that the substep visits: no particle stands behind them
    uint active_count;      // particles, quarantined ones too, as the last sort counted; inactive slots stand behind
    float dt_s;             // of the substep
    float time_s;           // simulated when the substep ends
    uint3 slot_groups;      // groups of PARTICLE_GROUP that visit the slots: a VkDispatchIndirectCommand
    float time_lost_s;      // what rounding has taken from time_s (Kahan 1965)
    uint vertex_count;      // a triangle for each slot: a VkDrawIndirectCommand
    uint instance_count;
    uint first_vertex;
    uint first_instance;
};

// The neighbour grid, x fastest: a cell for each of the domain's, or, in a domain far larger than its
// fluid (WRAPPED), powers of two that the domain's cells are wrapped onto. Cell `cell_count` holds
// what is outside or quarantined, which is nobody's neighbour; the one behind it holds inactive slots.
struct GridParams
{
    uint3 cells;
    uint cell_count;        // cells.x * cells.y * cells.z
    float cell_size_m;
    float inverse_cell_size_per_m;
    float support_m;        // h: the kernel is zero beyond it
    float inverse_support_per_m;
    uint3 domain_cells;
    uint list_chunks;       // room for neighbours a particle, in LIST_CHUNKs
    uint3 seam_cells;       // the domain's cells along axes that are periodic, more than it has along others
    uint reserved;
};

// Groups of the dispatches of a sort and of its lists, a VkDispatchIndirectCommand each, where the GPU says which substeps
// sort: none of a substep that keeps order and lists.
struct SearchGroups
{
    uint3 slots;            // that count particles, move them and list their neighbours
    uint reserved0;
    uint3 kept_slots;       // of those that stay in their order (keep_order.compute)
    uint reserved1;
    uint3 cells;            // that sum up and scan what cells hold
    uint reserved2;
    uint3 sums;             // likewise, of those groups' sums
    uint reserved3;
    uint3 sums_of_sums;
    uint reserved4;
};

// The smoothing kernel, Wendland C2, scaled so that the initial lattice has density ratio 1, and
// what it counts beyond walls (boundary/walls.hlsli).
struct SmoothingKernelParams
{
    float support_m;
    float inverse_support_per_m;
    float weight;           // 1 / sum of W over the lattice, W(0) = 1
    float wall_plane;       // density ratio of all space, as one wall's share of it counts
    float wall_edge;        // of two walls' product
    float wall_corner;      // of three walls'
    float along_z;          // 1; 0 in two dimensions, where nothing moves along z
    float reserved;
    float4 wall_kernel_fraction;      // the kernel's share beyond a wall that it reaches by t: t^5 times this polynomial of t
};

// Position Based Fluids, Macklin & Muller 2013. Lengths in units of h where no unit is named.
struct PbfParams
{
    float relaxation;       // of a correction: Jacobi under-relaxation, or 1 where lambda has it (PbfIteration)
    float cfm;              // constraint force mixing, in units of |grad C|^2 h^2
    float s_corr_k;         // artificial pressure, eq. (13)
    float s_corr_inverse_w; // 1 / W(dq)
    float max_correction_m; // an iteration moves a particle no further
    float separation;       // two particles closer than this part even below rest density
    float separation_lambda; // what is added to their lambdas at one point
    float warm_start;       // share of the last substep's pressure that the next one begins with
};

// What the corrections of a substep came to, for the next one to begin with (solver/pbf/start_warm.compute).
struct WarmStart
{
    float3 acceleration_m_s2;
    float multiplier_per_s2;    // all of its lambdas, over dt^2 as the acceleration is
};

// How an integrator splits the acceleration of a substep around its move (particles/advect.compute): the share of dt
// that velocities take of it before the move, after it, and when it is computed. They add up to 1.
struct KickParams
{
    float before;
    float after;
    float end;
    float reserved;
};

// One of the iterations of a substep whose lambdas have momentum (solver/pbf/momentum.hlsli).
struct PbfIteration
{
    float step;             // weight of the constraint
    float momentum;         // of the particle's lambda of the iteration before; 0 in the first
    float guarded_step;     // weight of the constraint where the fluid is very compressed
    uint begins_cold;       // 1 of the first iteration, unless a warm start wrote what stands before it
};

// What acts on velocities alone, whichever solver there is.
struct ForceParams
{
    float xsph;             // XSPH viscosity, Macklin & Muller 2013, eq. (17)
    float vorticity_m_s;    // vorticity confinement, eq. (16)
    float reserved0;
    float reserved1;
};

// A body force of place and time (forces/apply_fields.compute).
struct ForceField
{
    float3 acceleration_m_s2;   // everywhere alike
    float frequency_hz;         // that it swings with; 0: steady
    float3 swirl_per_s2;        // around the centre: swirl x (x - centre)
    float begin_s;
    float3 centre_m;
    float end_s;
};

struct ForceFieldCount
{
    uint fields;
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

// What is counted rather than hidden. Each is a sum since it was last cleared.
struct Counters
{
    uint neighbour_overflow;    // neighbours that had no slot
    uint speed_clamps;
    uint correction_clamps;
    uint displacement_clamps;   // that iterations would have moved by a support radius or more
    uint crowded;               // particles around which not all candidates were looked at
    uint capacity_overflow;     // particles that were to be activated when no slot was left
    uint long_substeps;         // that were longer than an explicit solver's limit
    uint emitted;               // particles that emitters put into slots
    uint density_iterations;    // of pressure solves that end by their residual: that hold the density
    uint divergence_iterations; // and that hold its change
    uint unsolved;              // such solves that did all iterations there were and had a residual left above tolerance
    uint drained;               // particles whose slots drains emptied, or the end of their lifetime did
    uint diffuse_spawned;       // diffuse particles (diffuse/layout.hlsli): that took a slot
    uint diffuse_ended;         // whose lifetime was over, or that left an open domain
    uint diffuse_overwritten;   // that younger ones took the slot of while they were there
    uint diffuse_dropped;       // that were due when no slot was left in the step
};

// Sums and extremes of one group of particles; the last stage reduces them to one of these.
struct MeasureSums
{
    float density_error_sum;    // of |rho/rho0 - 1|
    float density_error_max;
    float compression_sum;      // of max(rho/rho0 - 1, 0)
    float compression_max;
    float3 position_sum_m;
    float front_m;              // largest x
    float3 velocity_sum_m_s;
    float speed_max_m_s;
    float speed_squared_sum_m2_s2;
    uint particles;             // that were measured
    uint quarantined;
    uint escaped;               // outside an open domain
};

// What a measurement gives back to the host.
struct Measure
{
    MeasureSums sums;
    float density_error_p99;
    float compression_p99;
    uint reserved0;
    uint reserved1;
    Counters counters;
};

// A drag through the fluid: what is near a ray is drawn toward a velocity.
struct DragParams
{
    float3 origin_m;        // of the ray
    float radius_m;         // nothing beyond it is touched
    float3 direction;       // of the ray, of length 1
    float share;            // of the way to the velocity that is made up on the ray itself, 0 to 1
    float3 velocity_m_s;
    float along_z;          // 1; 0 in two dimensions, where nothing moves along z
    float near_m;           // nothing before this distance along the ray is touched
    float far_m;            // nor behind this one
    uint reserved0;
    uint reserved1;
};

// A block of particles to activate, on a lattice.
struct ActivateParams
{
    float3 first_m;         // the particle at the block's lowest corner
    float spacing_m;
    float3 velocity_m_s;
    uint fluid;
    uint3 counts;           // particles along each axis; any 0: none
    uint capacity;          // slots there are
};

// A box whose particles are deactivated.
struct DeactivateParams
{
    float3 min_m;
    uint reserved0;
    float3 max_m;           // below min_m: none
    uint reserved1;
};

// Which particles a capture keeps.
struct SampleParams
{
    uint stride;            // those whose id is a multiple of it
    uint capacity;          // ids are below it
    uint reserved0;
    uint reserved1;
};

#endif
