// A particle's density ratio where a step left it: itself, its neighbours, the walls. Includers
// declare `positions`, the lists, `step_params` and `kernel`, and include boundary/boundary.hlsli, and
// with PERIODIC shared/periodic.hlsli.
#ifndef BROOKLET_DENSITY
#define BROOKLET_DENSITY

float DensityRatio(uint i, float3 x_i_m)
{
    float density = 1.0; // W(0) of itself
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
            float q = length(offset_m) * kernel.inverse_support_per_m;
            density += deltas[k] == LIST_ESCAPE ? 0.0 : WendlandW(q);
        }
    }
    density *= kernel.weight;
    density += SampleBoundary(x_i_m, step_params, kernel).density;
    return density;
}

#endif
