// What the host tells of the domain's walls.
#ifndef BROOKLET_BOUNDARY_LAYOUT
#define BROOKLET_BOUNDARY_LAYOUT

// How one of the six drags the fluid along it (boundary/drag_walls.compute).
struct WallFace
{
    float3 velocity_m_s;    // its own, along it
    float shear_m2_s;       // twice the kinematic viscosity, scaled; 0 where the fluid may slip
    float friction;         // c_f of a shear stress of c_f/2 rho v^2, scaled
    float reserved0;
    float reserved1;
    float reserved2;
};

// How walls keep the fluid (boundary/repel_walls.compute).
static const uint WALLS_BY_PENALTY = 0;
static const uint WALLS_BY_DEFLECTION = 1;

struct RepelParams
{
    uint model;                 // one of these
    float reach_m;              // of a wall: half a spacing, where the lattice's first layer is
    float stiffness_per_s2;     // of a penalty, over the particle's mass
    float damping_per_s;
    float restitution;          // of a deflection
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

#endif
