// A particle's density ratio where a step left it: itself, its neighbours, the walls. Includers
// declare `positions`, the lists, `step_params` and `kernel`, and WALLS includes boundary/walls.hlsl,
// PERIODIC shared/periodic.hlsl.
#ifndef BROOKLET_DENSITY
#define BROOKLET_DENSITY

float DensityRatio(uint i, float3 here_m)
{
    ListHead list = list_heads[i];
    uint chunks = ChunksOf(list);
    uint last = list.first - 1;
    uint at = FirstChunk(i, step_params.list_chunks);
    float density = 1.0; // W(0) of itself
    for (uint chunk = 0; chunk < chunks; ++chunk, at += LIST_SLICE)
    {
        uint4 gaps = GapsOf(neighbours[at]);
        [unroll]
        for (uint k = 0; k < LIST_CHUNK; ++k)
        {
            uint j = Follow(last, gaps[k], i);
            float3 apart_m = here_m - positions[j].position_m;
#if defined(PERIODIC)
            apart_m = NearestImage(apart_m, step_params);
#endif
            float q = length(apart_m) * kernel.inverse_support_per_m;
            density += gaps[k] == LIST_NOBODY ? 0.0 : WendlandW(q);
        }
    }
    density *= kernel.weight;
#if defined(WALLS)
    density += WallDensity(WallSharesAt(here_m, step_params, kernel), kernel);
#endif
    return density;
}

#endif
