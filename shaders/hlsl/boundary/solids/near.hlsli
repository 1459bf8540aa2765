// The solids that a particle may meet. Includers declare `solid_blocks`, `solid_poses` and `solids_params`.
#ifndef BROOKLET_NEAR_SOLIDS
#define BROOKLET_NEAR_SOLIDS

#include "layout.hlsli"

uint4 SolidsNear(float3 position_m)
{
    float3 place = position_m * solids_params.inverse_block_per_m;
    uint3 block = uint3(clamp(int3(floor(place)), 0, int3(solids_params.blocks) - 1));
    return solid_blocks[(block.z * solids_params.blocks.y + block.y) * solids_params.blocks.x + block.x];
}

// Whether all that lies between two corners is further from a solid's box than `within_m`, which is at most `reach_m`.
bool IsBeside(uint s, float3 low_m, float3 high_m, float within_m)
{
    float margin_m = solids_params.reach_m - within_m;
    return any(high_m < solid_poses[s].min_m + margin_m) || any(low_m > solid_poses[s].max_m - margin_m);
}

#endif
