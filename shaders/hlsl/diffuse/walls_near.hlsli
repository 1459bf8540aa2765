// What of a ball of radius h around a point lies inside the domain's walls, and what the fluid that they stand for adds to a
// normal. Includers bind `step_params`, and `grid` or `kernel` for h.
#ifndef BROOKLET_WALLS_NEAR
#define BROOKLET_WALLS_NEAR

// Of a ball of radius 1 on this side of a plane at the distance t from its middle.
float3 ShareBefore(float3 t)
{
    t = saturate(t);
    return 0.25 * (2.0 + t * (3.0 - t * t));
}

// Along each axis as if walls were alone.
float ShareInside(float3 position_m, float inverse_support_per_m)
{
    float3 low = ShareBefore((position_m - step_params.wall_min_m) * inverse_support_per_m);
    float3 high = ShareBefore((step_params.wall_max_m - position_m) * inverse_support_per_m);
    float3 inside = low * high;
    return inside.x * inside.y * inside.z;
}

// The integral of cos(angle) (1 - r/h) over the part of a ball of radius 1 beyond a plane at t, over its value at t = 0.
float3 NormalBeyond(float3 t)
{
    t = saturate(t);
    float3 t2 = t * t;
    return 1.0 - t2 * (6.0 - t * (8.0 - 3.0 * t));
}

// Of all of them together.
float3 NormalOfWalls(float3 position_m, float inverse_support_per_m)
{
    return NormalBeyond((position_m - step_params.wall_min_m) * inverse_support_per_m)
        - NormalBeyond((step_params.wall_max_m - position_m) * inverse_support_per_m);
}

#endif
