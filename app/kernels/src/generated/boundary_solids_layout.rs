// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/solids/layout.hlsli.
//! Host-visible structs of `boundary/solids/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Solids of a scene: a bit each in a block's mask.
pub const MAX_SOLIDS: u32 = 128;

/// Words of such a mask.
pub const SOLID_MASK_WORDS: u32 = 4;

/// From where on a particle knows of a solid, in h: iterations move it by less than one, and it stays half a spacing from a
/// surface, a third of h at most.
pub const CONTACT_REACH: f32 = 1.5;

/// What a solid's numbers mean (boundary/solids/shapes.hlsli).
pub const SHAPE_BOX: u32 = 0;

/// a sphere with half a length of 0
pub const SHAPE_CAPSULE: u32 = 1;

/// `SHAPE_CYLINDER`.
pub const SHAPE_CYLINDER: u32 = 2;

/// distances on a grid (field.hlsli)
pub const SHAPE_FIELD: u32 = 3;

/// A solid's shape, in its own frame: its middle at the origin, its axis along y.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Solid {
    /// of a box its sides, of a cylinder (radius, half its length, radius), of a capsule the same
    pub half_m: [f32; 3],
    /// `uint`.
    pub shape: u32,
    /// what is hollow of it, as a shape of the same kind between these; beyond half\_m where it is open
    pub cavity_min_m: [f32; 3],
    /// `uint`.
    pub is_hollow: u32,
    /// `float3`.
    pub cavity_max_m: [f32; 3],
    /// of a contact: share of the normal impulse that acts along it (Coulomb)
    pub friction: f32,
    /// half the sides of the box around it
    pub extent_m: [f32; 3],
    /// share of the speed across it that a contact gives back
    pub restitution: f32,
    /// of its motion
    pub first_keyframe: u32,
    /// `uint`.
    pub keyframe_count: u32,
    /// after which keyframes begin again; 0: they end
    pub period_s: f32,
    /// whose reaction it gives: below body\_count it is that body, else it moves by its keyframes, and
    pub body: u32,
    /// lowest node of a field
    pub field_min_m: [f32; 3],
    /// between two of its nodes
    pub field_cell_m: f32,
    /// along each side, two or more
    pub field_nodes: [u32; 3],
    /// of all fields' nodes; x goes fastest
    pub first_field_node: u32,
}
const _: () = {
    assert!(offset_of!(Solid, half_m) == 0);
    assert!(offset_of!(Solid, shape) == 12);
    assert!(offset_of!(Solid, cavity_min_m) == 16);
    assert!(offset_of!(Solid, is_hollow) == 28);
    assert!(offset_of!(Solid, cavity_max_m) == 32);
    assert!(offset_of!(Solid, friction) == 44);
    assert!(offset_of!(Solid, extent_m) == 48);
    assert!(offset_of!(Solid, restitution) == 60);
    assert!(offset_of!(Solid, first_keyframe) == 64);
    assert!(offset_of!(Solid, keyframe_count) == 68);
    assert!(offset_of!(Solid, period_s) == 72);
    assert!(offset_of!(Solid, body) == 76);
    assert!(offset_of!(Solid, field_min_m) == 80);
    assert!(offset_of!(Solid, field_cell_m) == 92);
    assert!(offset_of!(Solid, field_nodes) == 96);
    assert!(offset_of!(Solid, first_field_node) == 108);
    assert!(size_of::<Solid>() == 112);
};

/// Where a solid is at a time; between two it moves evenly, and turns evenly around one axis.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Keyframe {
    /// `float3`.
    pub position_m: [f32; 3],
    /// `float`.
    pub time_s: f32,
    /// of its frame: a quaternion (x, y, z, w)
    pub rotation: [f32; 4],
}
const _: () = {
    assert!(offset_of!(Keyframe, position_m) == 0);
    assert!(offset_of!(Keyframe, time_s) == 12);
    assert!(offset_of!(Keyframe, rotation) == 16);
    assert!(size_of::<Keyframe>() == 32);
};

/// Where a solid is at a substep's end, and at its begin.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SolidPose {
    /// `float3`.
    pub position_m: [f32; 3],
    /// `float`.
    pub reserved0: f32,
    /// `float4`.
    pub rotation: [f32; 4],
    /// `float3`.
    pub before_m: [f32; 3],
    /// `float`.
    pub reserved1: f32,
    /// `float4`.
    pub rotation_before: [f32; 4],
    /// the box around both, and around what is near enough to feel it
    pub min_m: [f32; 3],
    /// `float`.
    pub reserved2: f32,
    /// `float3`.
    pub max_m: [f32; 3],
    /// `float`.
    pub reserved3: f32,
}
const _: () = {
    assert!(offset_of!(SolidPose, position_m) == 0);
    assert!(offset_of!(SolidPose, reserved0) == 12);
    assert!(offset_of!(SolidPose, rotation) == 16);
    assert!(offset_of!(SolidPose, before_m) == 32);
    assert!(offset_of!(SolidPose, reserved1) == 44);
    assert!(offset_of!(SolidPose, rotation_before) == 48);
    assert!(offset_of!(SolidPose, min_m) == 64);
    assert!(offset_of!(SolidPose, reserved2) == 76);
    assert!(offset_of!(SolidPose, max_m) == 80);
    assert!(offset_of!(SolidPose, reserved3) == 92);
    assert!(size_of::<SolidPose>() == 96);
};

/// What a particle knows of the solids near it: a half-space that adds as much density as they do, and a plane that it may
/// not pass. Both are of the nearest part, and hold for as far as a substep's iterations move it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SolidContact {
    /// out of the half-space, which is beyond normal \* x \< offset\_m; 0 where none is near
    pub normal: [f32; 3],
    /// `float`.
    pub offset_m: f32,
    /// out of the nearest solid
    pub stop_normal: [f32; 3],
    /// of its surface
    pub stop_offset_m: f32,
    /// the nearest
    pub solid: u32,
    /// of the nearest solid there, along `normal`
    pub speed_m_s: f32,
    /// of the nearest, or NO\_BODY
    pub body: u32,
    /// `uint`.
    pub reserved1: u32,
    /// change of velocity that iterations gave the particle for solids, which a body gives back
    pub taken_m_s: [f32; 3],
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(SolidContact, normal) == 0);
    assert!(offset_of!(SolidContact, offset_m) == 12);
    assert!(offset_of!(SolidContact, stop_normal) == 16);
    assert!(offset_of!(SolidContact, stop_offset_m) == 28);
    assert!(offset_of!(SolidContact, solid) == 32);
    assert!(offset_of!(SolidContact, speed_m_s) == 36);
    assert!(offset_of!(SolidContact, body) == 40);
    assert!(offset_of!(SolidContact, reserved1) == 44);
    assert!(offset_of!(SolidContact, taken_m_s) == 48);
    assert!(offset_of!(SolidContact, reserved2) == 60);
    assert!(size_of::<SolidContact>() == 64);
};

/// All of them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SolidsParams {
    /// of the domain, each with a mask of the solids near it
    pub blocks: [u32; 3],
    /// `uint`.
    pub solid_count: u32,
    /// `float3`.
    pub inverse_block_per_m: [f32; 3],
    /// from a surface, within which a particle knows of it
    pub reach_m: f32,
    /// `float3`.
    pub block_m: [f32; 3],
    /// particles stay at least this far from a surface
    pub stop_m: f32,
    /// `uint`.
    pub body_count: u32,
    /// of all bodies' surfaces
    pub point_count: u32,
    /// of a reaction's sum, a particle's change of velocity; 0 where nothing has a reaction
    pub units_per_m_s: f32,
    /// the impulse that is one of those
    pub unit_kg_m_s: f32,
}
const _: () = {
    assert!(offset_of!(SolidsParams, blocks) == 0);
    assert!(offset_of!(SolidsParams, solid_count) == 12);
    assert!(offset_of!(SolidsParams, inverse_block_per_m) == 16);
    assert!(offset_of!(SolidsParams, reach_m) == 28);
    assert!(offset_of!(SolidsParams, block_m) == 32);
    assert!(offset_of!(SolidsParams, stop_m) == 44);
    assert!(offset_of!(SolidsParams, body_count) == 48);
    assert!(offset_of!(SolidsParams, point_count) == 52);
    assert!(offset_of!(SolidsParams, units_per_m_s) == 56);
    assert!(offset_of!(SolidsParams, unit_kg_m_s) == 60);
    assert!(size_of::<SolidsParams>() == 64);
};
