// What the host tells of particles that do not interact.
#ifndef BROOKLET_NONE_LAYOUT
#define BROOKLET_NONE_LAYOUT

struct NoneParams
{
    float lifetime_s;           // 0: for ever
    float lifetime_variation;   // share of the lifetime by which the shortest lives less
    float drag_per_s;           // velocity decays as exp(-drag t)
    float restitution;          // share of the speed across a wall that a bounce gives back
};

#endif
