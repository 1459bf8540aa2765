// A particle's kernel in an anisotropic field.
#ifndef BROOKLET_MESH_KERNEL
#define BROOKLET_MESH_KERNEL

#include "layout.hlsli"

// From an offset to q, 1/m.
float3x3 MatrixOf(MeshKernel kernel)
{
    float3 diagonal = kernel.diagonal_per_m;
    float3 beside = kernel.beside_per_m;
    return float3x3(diagonal.x, beside.x, beside.y, beside.x, diagonal.y, beside.z, beside.y, beside.z, diagonal.z);
}

#endif
