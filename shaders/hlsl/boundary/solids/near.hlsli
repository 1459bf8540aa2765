// The solids that a particle may meet. Includers declare `solid_blocks` and `solids_params`.
#ifndef BROOKLET_NEAR_SOLIDS
#define BROOKLET_NEAR_SOLIDS

#include "layout.hlsli"

uint4 SolidsNear(float3 position_m)
{
    float3 place = position_m * solids_params.inverse_block_per_m;
    uint3 block = uint3(clamp(int3(floor(place)), 0, int3(solids_params.blocks) - 1));
    return solid_blocks[(block.z * solids_params.blocks.y + block.y) * solids_params.blocks.x + block.x];
}

#endif
