// The images that a particle sees, of what its factors keep.
#ifndef BROOKLET_DFSPH_MIRRORS
#define BROOKLET_DFSPH_MIRRORS

#include "../../boundary/mirror.hlsli"
#include "layout.hlsli"

#if defined(WALLS)
Mirrors MirrorsOf(PressureFactors factors, float supports_per_unit)
{
#if defined(SOLID_WALLS)
    return MirrorsNear(factors.from_walls, UnpackDirection(factors.solid_normal), factors.from_solids, factors.solid_speed_m_s,
                       supports_per_unit);
#else
    return MirrorsAt(factors.from_walls, supports_per_unit);
#endif
}
#endif

#endif
