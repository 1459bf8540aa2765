// What the host tells of SPH, and what only the GPU knows of its substeps.
#ifndef BROOKLET_SPH_LAYOUT
#define BROOKLET_SPH_LAYOUT

// The share of surface tension's stress that is the same in all directions: Lafaurie's 1, and a quarter more. At 1 particles of the
// surface clump, which draw each other along it (the tensile instability); at 2 a drop swings a tenth too slowly.
static const float ISOTROPIC = 1.25;

// The kernels of density, pressure and viscosity as polynomials of t = 1 - q and s = 1 - 2 q, each 0 where it would be
// less, without unit (host: solver/sph/kernels.rs). Scaled so that on the initial lattice the density ratio is 1, an even
// slope of pressure has its own gradient, and a parabola of velocities its own Laplacian.
struct SphKernels
{
    float4 density;             // of t^3, t^4, t^5, t^6
    float4 pressure;            // -W'/q: of t, t^2, t^3, t^4
    float4 viscosity;           // of a difference of velocities in the Laplacian, likewise
    float density_spline;       // of s^3
    float density_self;         // of the particle itself
    float pressure_inverse;     // of t^2 / q
    float pressure_spline;      // of s^2 / q
    float viscosity_inverse;
    float viscosity_spline;
    float tension;              // of (1 - q^2)^2: -W'/q of the colour field's kernel, poly6, scaled as the pressure's
    float reserved0;
};

// A particle's velocity, and its pressure over the square of its density, as pairs gather them.
struct VelocityPressure
{
    float3 velocity_m_s;
    float pressure_m2_s2;       // p / (rho0 (rho/rho0)^2)
};

// The gradient of the colour field, 1 in the fluid and 0 outside, over the particle's position.
struct SurfaceNormal
{
    float3 normal;              // 1/h; into the fluid
    float length;
};

// A particle's both, side by side: one binding fewer, of which the floor tier has eight.
struct VelocityPressureNormal
{
    VelocityPressure flow;
    SurfaceNormal surface;
};

// The terms. Pressures are over the rest density, m^2/s^2.
struct SphParams
{
    float stiffness_m2_s2;      // k of p = k (rho - rho0): the square of the speed of sound
    float exponent;             // gamma of Tait's equation; 1: linear
    float least_pressure_m2_s2; // 0 where pressure is clamped, far below everything where not
    float viscosity_m2_s;       // kinematic
    float tension_m3_s2;        // surface tension over the rest density, and over what the layers of a plane surface sum to
    float separation;           // in h; closer pairs part even below rest density
    float separation_m2_s2;     // the pressure of a pair at one point
    float supported_per_m2_s2;  // 1 over the pressure from which on walls bear all of the fluid's weight
    float borne_scale;          // of what walls bear, so that the lattice's first layer is at rest
    float end_kick;             // KickParams::end
    uint defers_pressure;       // 1 where solids add to the density before it becomes a pressure (add_solid_density.compute)
    float surface_linear;       // CompletedDensity's, of the length of the colour field's gradient
    float surface_square;       // of its square
    float most_normal;          // of it that counts, 1/h: little more than a plane surface's
    float reserved0;
    float reserved1;
};

// What limits the substeps (Monaghan 1992; Morris, Fox & Zhu 1997; Brackbill, Kothe & Zemach 1992).
struct SphLimits
{
    float cfl_m;                // over the speed of sound and the fastest particle's
    float sound_m_s;
    float force_m;              // over the largest acceleration, under the root
    float steady_s;             // least of the viscous and the surface tension's limit
    float step_s;               // what a step advances
    uint substeps;              // of a step, at most
    float list_reach_m;         // that particles may move until they are listed anew
    uint reserved0;
    uint3 scan_groups;          // SearchGroups' cells, sums and sums_of_sums of a substep that lists
    uint reserved1;
};

// What the substeps came to. Maxima are bits, which order as the positive numbers that they are do.
struct SphTimeStep
{
    uint max_speed_bits;        // m/s, of the last substep
    uint max_acceleration_bits; // m/s^2
    float limit_s;              // that the substep has to keep
    float left_s;               // of the step, where the GPU chooses its substeps
    uint substeps_left;
    float drift_m;              // that particles may have moved since they were listed
    uint reserved1;
    uint reserved2;
};

#endif
