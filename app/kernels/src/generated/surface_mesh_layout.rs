// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/layout.hlsli.
//! Host-visible structs of `surface/mesh/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Cells of a block along each axis: a block's 64 points are a group's threads.
pub const BLOCK_CELLS: u32 = 4;

/// Blocks along each side of the cube that a group marks.
pub const MARKED_BLOCKS: u32 = 4;

/// The field beyond a wall: so far below 0 that the surface is cut at the wall's own point, in f32 exactly.
pub const BEYOND_M: f32 = -1.0e15;

/// Reach of an ellipsoid's kernel along an axis that is not stretched, in spacings; (1 - q^2)^3 has 64 pi / 315 of its cube.
pub const KERNEL_REACH: f32 = 2.5;

/// No axis of an ellipsoid with a sphere's volume is stretched further: what is beyond the mesh's reach is not looked at.
pub const KERNEL_STRETCH: f32 = 1.3;

/// Blocks that a group makes the field of, a thread for two columns of four points each.
pub const FIELD_BLOCKS: u32 = 8;

/// What MeshParams::block\_entries says of a block that is not listed; of one that is, its place in the list and this much more.
pub const BLOCK_OUTSIDE: u32 = 0;

/// `BLOCK_INSIDE`.
pub const BLOCK_INSIDE: u32 = 1;

/// `BLOCK_LISTED`.
pub const BLOCK_LISTED: u32 = 2;

/// The bit of a listed block whose points within the walls are all inside, or all outside.
pub const BLOCK_UNIFORM: u32 = 0x80000000;

/// And the bit that says that they are inside.
pub const BLOCK_UNIFORM_INSIDE: u32 = 0x40000000;

/// A grid of cells over the domain and one block beyond it on each side, in blocks of 4 x 4 x 4. Walls stand at its
/// points. Bins of particles are whole cells wide.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MeshParams {
    /// of the first block, one block below the domain
    pub min_m: [f32; 3],
    /// `float`.
    pub spacing_m: f32,
    /// along each axis: the domain is so many whole cells
    pub cell_m: [f32; 3],
    /// of a particle
    pub reach_m: f32,
    /// `uint3`.
    pub blocks: [u32; 3],
    /// `uint`.
    pub block_count: u32,
    /// of the domain
    pub cells: [u32; 3],
    /// of a bin along each axis
    pub bin_cells: u32,
    /// `uint3`.
    pub bins: [u32; 3],
    /// `uint`.
    pub bin_count: u32,
    /// the first point that may be inside, along each axis: a wall, or the grid's second
    pub low_point: [u32; 3],
    /// of a particle alone
    pub radius_m: f32,
    /// the last one
    pub high_point: [u32; 3],
    /// `float`.
    pub least_weight: f32,
    /// walls behind which particles are mirrored; too far to matter where there are none
    pub wall_min_m: [f32; 3],
    /// `uint`.
    pub most_blocks: u32,
    /// `float3`.
    pub wall_max_m: [f32; 3],
    /// `uint`.
    pub most_vertices: u32,
    /// of 4 x 4 x 4 blocks
    pub mark_groups: [u32; 3],
    /// `uint`.
    pub most_triangles: u32,
}
const _: () = {
    assert!(offset_of!(MeshParams, min_m) == 0);
    assert!(offset_of!(MeshParams, spacing_m) == 12);
    assert!(offset_of!(MeshParams, cell_m) == 16);
    assert!(offset_of!(MeshParams, reach_m) == 28);
    assert!(offset_of!(MeshParams, blocks) == 32);
    assert!(offset_of!(MeshParams, block_count) == 44);
    assert!(offset_of!(MeshParams, cells) == 48);
    assert!(offset_of!(MeshParams, bin_cells) == 60);
    assert!(offset_of!(MeshParams, bins) == 64);
    assert!(offset_of!(MeshParams, bin_count) == 76);
    assert!(offset_of!(MeshParams, low_point) == 80);
    assert!(offset_of!(MeshParams, radius_m) == 92);
    assert!(offset_of!(MeshParams, high_point) == 96);
    assert!(offset_of!(MeshParams, least_weight) == 108);
    assert!(offset_of!(MeshParams, wall_min_m) == 112);
    assert!(offset_of!(MeshParams, most_blocks) == 124);
    assert!(offset_of!(MeshParams, wall_max_m) == 128);
    assert!(offset_of!(MeshParams, most_vertices) == 140);
    assert!(offset_of!(MeshParams, mark_groups) == 144);
    assert!(offset_of!(MeshParams, most_triangles) == 156);
    assert!(size_of::<MeshParams>() == 160);
};

/// A particle's part in an anisotropic field (Yu & Turk 2013, eq. 9): weight (1 - |G (x - center)|^2)^3.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MeshKernel {
    /// `float3`.
    pub center_m: [f32; 3],
    /// its integral is the particle's volume
    pub weight: f32,
    /// of G, symmetric: xx, yy, zz
    pub diagonal_per_m: [f32; 3],
    /// `float`.
    pub reserved0: f32,
    /// xy, xz, yz
    pub beside_per_m: [f32; 3],
    /// `float`.
    pub reserved1: f32,
}
const _: () = {
    assert!(offset_of!(MeshKernel, center_m) == 0);
    assert!(offset_of!(MeshKernel, weight) == 12);
    assert!(offset_of!(MeshKernel, diagonal_per_m) == 16);
    assert!(offset_of!(MeshKernel, reserved0) == 28);
    assert!(offset_of!(MeshKernel, beside_per_m) == 32);
    assert!(offset_of!(MeshKernel, reserved1) == 44);
    assert!(size_of::<MeshKernel>() == 48);
};

/// `MeshVertex`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MeshVertex {
    /// `float3`.
    pub position_m: [f32; 3],
    /// `float`.
    pub reserved0: f32,
    /// out of the fluid, of length 1
    pub normal: [f32; 3],
    /// `float`.
    pub reserved1: f32,
}
const _: () = {
    assert!(offset_of!(MeshVertex, position_m) == 0);
    assert!(offset_of!(MeshVertex, reserved0) == 12);
    assert!(offset_of!(MeshVertex, normal) == 16);
    assert!(offset_of!(MeshVertex, reserved1) == 28);
    assert!(size_of::<MeshVertex>() == 32);
};

/// What a frame's mesh came to. Its first four numbers are a VkDrawIndirectCommand, each uint3 a
/// VkDispatchIndirectCommand.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MeshCounts {
    /// `uint`.
    pub index_count: u32,
    /// `uint`.
    pub instance_count: u32,
    /// `uint`.
    pub first_vertex: u32,
    /// `uint`.
    pub first_instance: u32,
    /// one for each listed block
    pub block_groups: [u32; 3],
    /// listed
    pub blocks: u32,
    /// one for FIELD\_BLOCKS of them
    pub field_groups: [u32; 3],
    /// that found no place in the list
    pub lost_blocks: u32,
    /// of 64 vertices
    pub vertex_groups: [u32; 3],
    /// that found no place among the triangles, or whose vertices did not
    pub lost_triangles: u32,
    /// `uint`.
    pub vertices: u32,
    /// `uint`.
    pub triangles: u32,
    /// that found no place among the vertices
    pub lost_vertices: u32,
    /// `uint`.
    pub reserved0: u32,
}
const _: () = {
    assert!(offset_of!(MeshCounts, index_count) == 0);
    assert!(offset_of!(MeshCounts, instance_count) == 4);
    assert!(offset_of!(MeshCounts, first_vertex) == 8);
    assert!(offset_of!(MeshCounts, first_instance) == 12);
    assert!(offset_of!(MeshCounts, block_groups) == 16);
    assert!(offset_of!(MeshCounts, blocks) == 28);
    assert!(offset_of!(MeshCounts, field_groups) == 32);
    assert!(offset_of!(MeshCounts, lost_blocks) == 44);
    assert!(offset_of!(MeshCounts, vertex_groups) == 48);
    assert!(offset_of!(MeshCounts, lost_triangles) == 60);
    assert!(offset_of!(MeshCounts, vertices) == 64);
    assert!(offset_of!(MeshCounts, triangles) == 68);
    assert!(offset_of!(MeshCounts, lost_vertices) == 72);
    assert!(offset_of!(MeshCounts, reserved0) == 76);
    assert!(size_of::<MeshCounts>() == 80);
};
