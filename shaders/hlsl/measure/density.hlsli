// A particle's density ratio where a step left it: itself, its neighbours, the walls. Includers
// declare `positions`, the lists, `step_params` and `kernel`, and WALLS includes boundary/walls.hlsli,
// PERIODIC shared/periodic.hlsli.
#ifndef BROOKLET_DENSITY
#define BROOKLET_DENSITY

float DensityRatio(uint i, float3 x_i_m)
{
    ListHead list = list_heads[i];
    uint chunks = ChunkCount(list);
    uint last = list.first - 1;
    uint at = FirstChunk(i, step_params.list_chunks);
    float density = 1.0; // W(0) of itself
    for (uint chunk = 0; chunk < chunks; ++chunk, at += LIST_SLICE)
    {
        uint4 deltas = UnpackDeltas(neighbours[at]);
        [unroll]
        for (uint k = 0; k < LIST_CHUNK; ++k)
        {
            uint j = NextNeighbour(last, deltas[k], i);
            float3 offset_m = x_i_m - positions[j].position_m;
#if defined(PERIODIC)
            offset_m = NearestImage(offset_m, step_params);
#endif
            float q = length(offset_m) * kernel.inverse_support_per_m;
            density += deltas[k] == LIST_ESCAPE ? 0.0 : WendlandW(q);
        }
    }
    density *= kernel.weight;
#if defined(WALLS)
    density += WallDensity(WallKernelFractionsAt(x_i_m, step_params, kernel), kernel);
#endif
    return density;
}

#endif
