// Tait's equation of state. Includers declare `sph`.
#ifndef BROOKLET_SPH_PRESSURE
#define BROOKLET_SPH_PRESSURE

// Over the rest density, m^2/s^2.
float PressureOf(float density_ratio)
{
    float power = sph.exponent == 1.0 ? density_ratio : pow(density_ratio, sph.exponent);
    return max(sph.stiffness_m2_s2 / sph.exponent * (power - 1.0), sph.least_pressure_m2_s2);
}

// What pairs gather of it: over the square of the density.
float GatheredPressureOf(float density_ratio)
{
    return PressureOf(density_ratio) / (density_ratio * density_ratio);
}

#if defined(SURFACE_TENSION)
// With what a free surface lacks of density, as the length of the colour field's gradient tells it: exact in the two outer layers
// of a lattice. Without it nothing keeps the particles of a surface apart that its tension draws together.
float CompletedDensity(float density_ratio, SurfaceNormal surface)
{
    float normal = min(surface.length, sph.most_normal);
    return density_ratio + normal * (sph.surface_linear + normal * sph.surface_square);
}
#endif

#endif
