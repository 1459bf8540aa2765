// What light meets at water.
#ifndef BROOKLET_WATER_OPTICS
#define BROOKLET_WATER_OPTICS

// Reflectance of water at normal incidence, ((n - 1) / (n + 1))^2, and 1 / n.
static const float WATER_F0 = 0.0204;
static const float AIR_OVER_WATER = 0.7502;

#endif
