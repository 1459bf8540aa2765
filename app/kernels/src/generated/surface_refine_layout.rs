// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/layout.hlsli.
//! Host-visible structs of `surface/refine/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// `RefineParams`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct RefineParams {
    /// standard deviation of the weight over the distance of two vertices
    pub distance_m: f32,
    /// and over the difference of their normals
    pub difference: f32,
    /// of each side of a triangle: 1, 2 or 3
    pub parts: u32,
    /// as many as the mesh had room for
    pub most_coarse_vertices: u32,
    /// there is room for when it is subdivided
    pub most_vertices: u32,
    /// `uint`.
    pub most_triangles: u32,
}
const _: () = {
    assert!(offset_of!(RefineParams, distance_m) == 0);
    assert!(offset_of!(RefineParams, difference) == 4);
    assert!(offset_of!(RefineParams, parts) == 8);
    assert!(offset_of!(RefineParams, most_coarse_vertices) == 12);
    assert!(offset_of!(RefineParams, most_vertices) == 16);
    assert!(offset_of!(RefineParams, most_triangles) == 20);
    assert!(size_of::<RefineParams>() == 24);
};

/// A mesh's size. Each set of groups is a VkDispatchIndirectCommand.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MeshSize {
    /// with a thread for each vertex
    pub vertex_groups: [u32; 3],
    /// `uint`.
    pub vertices: u32,
    /// and one for each triangle
    pub triangle_groups: [u32; 3],
    /// `uint`.
    pub triangles: u32,
}
const _: () = {
    assert!(offset_of!(MeshSize, vertex_groups) == 0);
    assert!(offset_of!(MeshSize, vertices) == 12);
    assert!(offset_of!(MeshSize, triangle_groups) == 16);
    assert!(offset_of!(MeshSize, triangles) == 28);
    assert!(size_of::<MeshSize>() == 32);
};
