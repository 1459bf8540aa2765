// A particle's density ratio where a step left it: itself, its neighbours, the walls as its solver has them. Includers
// declare `positions`, the lists, `step_params` and `kernel`, and include boundary/boundary.hlsli, and
// with PERIODIC shared/periodic.hlsli.
#ifndef BROOKLET_DENSITY
#define BROOKLET_DENSITY

#include "../boundary/mirror.hlsli"

#if defined(WALLS)

// What images of x_j add, the first of them not being it.
float ImageDensity(float3 offset, Mirrors mirrors, uint images)
{
    float density = 0.0;
    [loop]
    for (uint image = 1; image < images; ++image)
        density += WendlandW(length(ImageOffset(offset, mirrors, image)));
    return density;
}

#endif

float DensityRatio(uint i, float3 x_i_m)
{
    float density = 1.0; // W(0) of itself
#if defined(WALLS)
    float3 from_walls = step_params.mirrors != 0 ? FromWalls(x_i_m, step_params, kernel) : NO_WALL;
#if defined(SOLID_WALLS)
    SolidContact contact = solid_contacts[i];
    float from_solids = (dot(contact.normal, x_i_m) - contact.offset_m) * kernel.inverse_support_per_m;
    Mirrors mirrors = MirrorsNear(from_walls, contact.normal, step_params.mirrors != 0 ? from_solids : NO_WALL, 0.0, 1.0);
#else
    Mirrors mirrors = MirrorsAt(from_walls, 1.0);
#endif
    density += ImageDensity(0.0, mirrors, mirrors.count);
#endif
    for (NeighbourCursor cursor = BeginNeighbours(i, list_heads[i], step_params.list_chunks); HasNeighbours(cursor);
         NextChunk(cursor))
    {
        uint4 deltas = UnpackDeltas(neighbours[cursor.chunk]);
        [unroll]
        for (uint k = 0; k < LIST_CHUNK; ++k)
        {
            uint j = NextNeighbour(cursor, deltas[k], i);
            float3 offset_m = x_i_m - positions[j].position_m;
#if defined(PERIODIC)
            offset_m = NearestImage(offset_m, step_params);
#endif
            float3 offset = offset_m * kernel.inverse_support_per_m;
            density += deltas[k] == LIST_ESCAPE ? 0.0 : WendlandW(length(offset));
#if defined(WALLS)
            density += ImageDensity(offset, mirrors, deltas[k] == LIST_ESCAPE ? 0 : mirrors.count);
#endif
        }
    }
    density *= kernel.weight;
    density += step_params.mirrors != 0 ? 0.0 : SampleBoundaryNear(i, x_i_m, step_params, kernel).density;
    return density;
}

#endif
