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

#endif
