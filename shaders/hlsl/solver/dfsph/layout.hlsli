// What the host tells of the two pressure solves of DFSPH, and what they keep.
#ifndef BROOKLET_DFSPH_LAYOUT
#define BROOKLET_DFSPH_LAYOUT

// One of the two solves, in an iteration of it. Pressures are multipliers without unit: p dt^2 / (rho0 h^2). Residuals are
// density ratios.
struct PressureSolve
{
    float tolerance;        // mean residual at which the iterations end
    float step;             // weight of the residual
    float momentum;         // of what the iteration before added; 0 in the first
    float guarded_step;     // weight of the residual where the fluid is very compressed
    float room_share;       // of what a particle is thinner than at rest: by so much it may grow denser
    float excess_share;     // of what it is denser: so much is to go
    float warm_share;       // of the last substep's pressures, with which the solve begins
    uint most_iterations;
    uint least_iterations;  // before which no residual ends it
    float solids_move;      // 1; 0 of displacements, in which solids have no part
    uint reserved1;
    uint reserved2;
};

// How far a solve is. Zero groups, and the iterations that are left do nothing.
struct SolveState
{
    uint3 groups;           // of an iteration's stages: a VkDispatchIndirectCommand
    uint iterations;        // done
    float residual;         // mean over the particles before the iteration that was looked at last
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

// What of a particle the iterations ask again and again.
struct PressureFactors
{
    float3 from_walls;          // boundary/mirror.hlsli, h
    float excess;               // density ratio - 1
    float inverse_stiffness;    // 0 of what takes no part
    uint solid_normal;          // out of the half-space that stands for the solids near it, packed (boundary/mirror.hlsli)
    float from_solids;          // h, signed; NO_WALL where there is none
    float solid_speed_m_s;      // of that half-space along its normal
};

#endif
