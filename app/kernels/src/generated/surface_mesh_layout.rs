// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/layout.hlsli.
//! Host-visible structs of `surface/mesh/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Cells of a block along each axis: a block's 64 points are a group's threads.
pub const BLOCK_CELLS: u32 = 4;

/// What MeshParams::block\_entries says of a block that is not listed; of one that is, its place in the list and this much more.
pub const BLOCK_OUTSIDE: u32 = 0;

/// `BLOCK_INSIDE`.
pub const BLOCK_INSIDE: u32 = 1;

/// `BLOCK_LISTED`.
pub const BLOCK_LISTED: u32 = 2;

/// The bit of a listed block whose field is the same at all of its points.
pub const BLOCK_UNIFORM: u32 = 0x80000000;

/// And the bit that says that it is inside there.
pub const BLOCK_UNIFORM_INSIDE: u32 = 0x40000000;

/// Particles of a block's bin from which on the bin counts as full of fluid: at rest it has 8.
pub const BIN_FULL: u32 = 5;

/// A grid of cells over the domain and one block beyond it on each side, in blocks of 4 x 4 x 4; a bin of particles for
/// each block within the domain.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MeshParams {
    /// of the first block, one block below the domain
    pub min_m: [f32; 3],
    /// `float`.
    pub cell_m: f32,
    /// `uint3`.
    pub blocks: [u32; 3],
    /// `uint`.
    pub block_count: u32,
    /// the walls' bounds: the fluid is cut off there; too far to matter without
    pub wall_min_m: [f32; 3],
    /// `float`.
    pub spacing_m: f32,
    /// `float3`.
    pub wall_max_m: [f32; 3],
    /// of a particle: REACH\_RATIO spacings, at most a block's side
    pub reach_m: f32,
    /// blocks less 2 along each axis
    pub bins: [u32; 3],
    /// of a particle alone
    pub radius_m: f32,
    /// `uint`.
    pub most_blocks: u32,
    /// `uint`.
    pub most_vertices: u32,
    /// `uint`.
    pub most_triangles: u32,
    /// `float`.
    pub least_weight: f32,
}
const _: () = {
    assert!(offset_of!(MeshParams, min_m) == 0);
    assert!(offset_of!(MeshParams, cell_m) == 12);
    assert!(offset_of!(MeshParams, blocks) == 16);
    assert!(offset_of!(MeshParams, block_count) == 28);
    assert!(offset_of!(MeshParams, wall_min_m) == 32);
    assert!(offset_of!(MeshParams, spacing_m) == 44);
    assert!(offset_of!(MeshParams, wall_max_m) == 48);
    assert!(offset_of!(MeshParams, reach_m) == 60);
    assert!(offset_of!(MeshParams, bins) == 64);
    assert!(offset_of!(MeshParams, radius_m) == 76);
    assert!(offset_of!(MeshParams, most_blocks) == 80);
    assert!(offset_of!(MeshParams, most_vertices) == 84);
    assert!(offset_of!(MeshParams, most_triangles) == 88);
    assert!(offset_of!(MeshParams, least_weight) == 92);
    assert!(size_of::<MeshParams>() == 96);
};

/// Field and its gradient at a point: above 0 inside.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct FieldPoint {
    /// `float3`.
    pub gradient: [f32; 3],
    /// `float`.
    pub field_m: f32,
}
const _: () = {
    assert!(offset_of!(FieldPoint, gradient) == 0);
    assert!(offset_of!(FieldPoint, field_m) == 12);
    assert!(size_of::<FieldPoint>() == 16);
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

/// What a frame's mesh came to. Its first four numbers are a VkDrawIndirectCommand, the next three a
/// VkDispatchIndirectCommand with a group for each listed block.
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
    /// `uint3`.
    pub block_groups: [u32; 3],
    /// listed
    pub blocks: u32,
    /// `uint`.
    pub vertices: u32,
    /// `uint`.
    pub triangles: u32,
    /// that found no place in the list
    pub lost_blocks: u32,
    /// that found no place among the triangles, or whose vertices did not
    pub lost_triangles: u32,
}
const _: () = {
    assert!(offset_of!(MeshCounts, index_count) == 0);
    assert!(offset_of!(MeshCounts, instance_count) == 4);
    assert!(offset_of!(MeshCounts, first_vertex) == 8);
    assert!(offset_of!(MeshCounts, first_instance) == 12);
    assert!(offset_of!(MeshCounts, block_groups) == 16);
    assert!(offset_of!(MeshCounts, blocks) == 28);
    assert!(offset_of!(MeshCounts, vertices) == 32);
    assert!(offset_of!(MeshCounts, triangles) == 36);
    assert!(offset_of!(MeshCounts, lost_blocks) == 40);
    assert!(offset_of!(MeshCounts, lost_triangles) == 44);
    assert!(size_of::<MeshCounts>() == 48);
};
