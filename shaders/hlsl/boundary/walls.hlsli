// What the domain's walls add to a particle's density ratio: the wall-weight function of Harada,
// Koshizuka & Kawaguchi 2007, in closed form. Without it particles see a void beyond a wall and
// pile up there.
//
// Beyond one wall lies a share of the kernel that is a polynomial of the distance (in two dimensions
// nearly, within .0001: host). Wendland's C2
// kernel is so nearly a product of three kernels along the axes that beyond two or three walls at
// right angles lies the product of their shares (within .003 where particles may be; test
// `products_of_planes_are_close_to_edges_and_corners`). By inclusion and exclusion edges and corners
// count once, and each term is scaled to what the lattice lacks half a spacing from its walls
// (host: boundary/walls). No table: a load costs more than all of this arithmetic.
#ifndef BROOKLET_WALLS
#define BROOKLET_WALLS

#include "../shared/layout.hlsli"

// Along each axis, what of the kernel lies beyond the two walls.
struct WallKernelFractions
{
    float3 share;
    float3 slope;   // of the share over the position, 1/h
    float3 moment;  // of the slopes, each times its wall's distance in h
};

// Of one wall's share, 1/h: how it grows towards a wall into which the kernel reaches by `reach`, in h.
float3 WallShareSlope(float3 reach, SmoothingKernelParams kernel)
{
    float4 by = kernel.wall_kernel_fraction * float4(5.0, 6.0, 7.0, 8.0);
    return reach * reach * (reach * reach) * (by.x + reach * (by.y + reach * (by.z + reach * by.w)));
}

WallKernelFractions WallKernelFractionsAt(float3 position_m, StepParams step, SmoothingKernelParams kernel)
{
    // How far the kernel reaches into each wall, in h.
    float3 low = saturate(1.0 - (position_m - step.wall_min_m) * kernel.inverse_support_per_m);
    float3 high = saturate(1.0 - (step.wall_max_m - position_m) * kernel.inverse_support_per_m);
    float4 of = kernel.wall_kernel_fraction;
    float3 low4 = low * low * (low * low);
    float3 high4 = high * high * (high * high);
    WallKernelFractions walls;
    walls.share = low4 * low * (of.x + low * (of.y + low * (of.z + low * of.w)))
                + high4 * high * (of.x + high * (of.y + high * (of.z + high * of.w)));
    float3 low_slope = WallShareSlope(low, kernel);
    float3 high_slope = WallShareSlope(high, kernel);
    walls.slope = high_slope - low_slope;
    walls.moment = (1.0 - low) * low_slope + (1.0 - high) * high_slope;
    return walls;
}

// A position that walls keep their distance from.
float3 InsideWalls(float3 position_m, StepParams step)
{
    return clamp(position_m, step.wall_min_m + step.wall_offset_m, step.wall_max_m - step.wall_offset_m);
}

// The density ratio that the walls add.
float WallDensity(WallKernelFractions walls, SmoothingKernelParams kernel)
{
    float3 share = walls.share;
    return kernel.wall_plane * (share.x + share.y + share.z)
         - kernel.wall_edge * (share.x * share.y + share.y * share.z + share.z * share.x)
         + kernel.wall_corner * (share.x * share.y * share.z);
}

// Its gradient, 1/h.
float3 WallGradient(WallKernelFractions walls, SmoothingKernelParams kernel)
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
float3 AlongWalls(WallKernelFractions walls, SmoothingKernelParams kernel)
{
    float3 left = 1.0 - min(kernel.wall_plane * walls.share, 0.5);
    return 1.0 / (left.yzx * left.zxy);
}

// What walls bear of the fluid's weight across them, along each axis: the integral of u dW/du beyond, u from the particle, with
// which a pressure that grows by rho g u pushes back. By parts that is the density beyond and the wall's distance times its
// slope.
float3 WallBorne(WallKernelFractions walls, SmoothingKernelParams kernel)
{
    return kernel.wall_plane * (walls.share + walls.moment);
}

#endif
