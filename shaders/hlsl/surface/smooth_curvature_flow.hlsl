// One step of screen-space curvature flow (van der Laan, Green & Sainz 2009): the surface moves
// along the line of sight by its mean curvature, dz/dt = 2H, as surface tension would have it.
// With pixels p = z a wide in the world, D = z_x^2 + z_y^2 + p^2 (eq. 5 with square pixels) and
// 2H = (E_x + E_y) / (D^1.5 p), E_x = z_xx D - z_x D_x / 2 (eq. 6-8, here in metres so that a time
// is an area, the same near and far).
#pragma vertex SmoothCurvatureFlowVertex
#pragma fragment SmoothCurvatureFlowFragment

#include "filter.hlsli"

Varyings SmoothCurvatureFlowVertex(uint vertex : SV_VertexID)
{
    return Covering(vertex);
}

// Distance in a neighbour pixel; the pixel's own where another surface is seen or none, which
// makes the derivative there zero: silhouettes do not move.
float DistanceAt(int2 pixel, float here, float z_m)
{
    float there = InverseDepthOf(pixel);
    bool same = there > 0.0 && abs(there - here) < InverseDepthDifference(surface.range_m, here);
    return same ? 1.0 / there : z_m;
}

float4 SmoothCurvatureFlowFragment(Varyings input) : SV_Target0
{
    int2 pixel = int2(input.position.xy);
    float here = InverseDepthOf(pixel);
    if (here <= 0.0)
        return 0.0;
    float z = 1.0 / here;
    float p = z * view.pixel_angle;
    float left = DistanceAt(pixel + int2(-1, 0), here, z);
    float right = DistanceAt(pixel + int2(1, 0), here, z);
    float above = DistanceAt(pixel + int2(0, -1), here, z);
    float below = DistanceAt(pixel + int2(0, 1), here, z);
    float left_above = DistanceAt(pixel + int2(-1, -1), here, z);
    float right_above = DistanceAt(pixel + int2(1, -1), here, z);
    float left_below = DistanceAt(pixel + int2(-1, 1), here, z);
    float right_below = DistanceAt(pixel + int2(1, 1), here, z);

    float zx = 0.5 * (right - left);
    float zy = 0.5 * (below - above);
    float zxx = (right - z) - (z - left);
    float zyy = (below - z) - (z - above);
    float zxy = 0.25 * ((right_below - left_below) - (right_above - left_above));
    float d = zx * zx + zy * zy + p * p;
    // p grows with z: its derivative is a z_x.
    float dx = 2.0 * (zx * zxx + zy * zxy + p * view.pixel_angle * zx);
    float dy = 2.0 * (zx * zxy + zy * zyy + p * view.pixel_angle * zy);
    float ex = zxx * d - 0.5 * zx * dx;
    float ey = zyy * d - 0.5 * zy * dy;
    float twice_curvature = (ex + ey) / (d * sqrt(d) * p);
    // An explicit step is stable up to p^2 / 4 (two dimensions, diffusivity one).
    float moved = twice_curvature * min(surface.flow_m2, 0.22 * p * p);
    return 1.0 / (z + clamp(moved, -surface.clamp_m, surface.clamp_m));
}
