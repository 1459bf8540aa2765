// What the domain's walls add to a particle's density ratio: the wall-weight function of Harada,
// Koshizuka & Kawaguchi 2007, in closed form. Without it particles see a void beyond a wall and
// pile up there.
//
// Beyond one wall lies a share of the kernel that is a polynomial of the distance. Wendland's C2
// kernel is so nearly a product of three kernels along the axes that beyond two or three walls at
// right angles lies the product of their shares (within .003 where particles may be; test
// `products_of_planes_are_close_to_edges_and_corners`). By inclusion and exclusion edges and corners
// count once, and each term is scaled to what the lattice lacks half a spacing from its walls
// (host: boundary/walls). No table: a load costs more than all of this arithmetic.
#ifndef BROOKLET_WALLS
#define BROOKLET_WALLS

#include "../shared/layout.hlsl"

// Along each axis, what of the kernel lies beyond the two walls.
struct WallShares
{
    float3 share;
    float3 slope;   // of the share over the position, 1/h
};

WallShares WallSharesAt(float3 position_m, float3 domain_size_m, KernelParams kernel)
{
    // How far the kernel reaches into each wall, in h.
    float3 low = saturate(1.0 - position_m * kernel.inverse_support_per_m);
    float3 high = saturate(1.0 - (domain_size_m - position_m) * kernel.inverse_support_per_m);
    float3 low2 = low * low;
    float3 high2 = high * high;
    float3 low5 = low2 * low2 * low;
    float3 high5 = high2 * high2 * high;
    WallShares walls;
    walls.share = low5 * low * (3.5 + low * (1.5 * low - 4.5)) + high5 * high * (3.5 + high * (1.5 * high - 4.5));
    walls.slope = high5 * (21.0 + high * (12.0 * high - 31.5)) - low5 * (21.0 + low * (12.0 * low - 31.5));
    return walls;
}

// The density ratio that the walls add.
float WallDensity(WallShares walls, KernelParams kernel)
{
    float3 share = walls.share;
    return kernel.wall_plane * (share.x + share.y + share.z)
         - kernel.wall_edge * (share.x * share.y + share.y * share.z + share.z * share.x)
         + kernel.wall_corner * (share.x * share.y * share.z);
}

// Its gradient, 1/h.
float3 WallGradient(WallShares walls, KernelParams kernel)
{
    float3 share = walls.share;
    return walls.slope * (kernel.wall_plane - kernel.wall_edge * (share.yzx + share.zxy)
                          + kernel.wall_corner * (share.yzx * share.zxy));
}

// How much of a correction along each axis the fluid's own neighbours give near walls along the
// others, inverted. Behind a wall the fluid's mirror image would push along the wall as well, in
// proportion to the kernel that lies there: the integral of -y dW/dy beyond the wall is that of W.
// Without it the layer at a wall feels too little of the pressure's slope along the wall, sinks,
// and stirs water that should rest.
float3 AlongWalls(WallShares walls, KernelParams kernel)
{
    float3 left = 1.0 - min(kernel.wall_plane * walls.share, 0.5);
    return 1.0 / (left.yzx * left.zxy);
}

#endif
