// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from diffuse/layout.hlsli.
//! Host-visible structs of `diffuse/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Shares of the fluid particles that are near one with fluid all around: below the one it is spray, above the other a
/// bubble, and foam between. The paper's 6 and 20, of the 33 that lie within h = 2 d.
pub const SPRAY_BELOW: f32 = 0.18;

/// `BUBBLE_ABOVE`.
pub const BUBBLE_ABOVE: f32 = 0.6;

/// How many a fluid particle spawns in a step, at most.
pub const MOST_SPAWNED: u32 = 256;

/// One of them. A lifetime of 0 is an empty slot.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DiffuseParticle {
    /// `float3`.
    pub position_m: [f32; 3],
    /// that is left
    pub lifetime_s: f32,
    /// `float3`.
    pub velocity_m_s: [f32; 3],
    /// share of the fluid particles that are near one with fluid all around
    pub crowd: f32,
}
const _: () = {
    assert!(offset_of!(DiffuseParticle, position_m) == 0);
    assert!(offset_of!(DiffuseParticle, lifetime_s) == 12);
    assert!(offset_of!(DiffuseParticle, velocity_m_s) == 16);
    assert!(offset_of!(DiffuseParticle, crowd) == 28);
    assert!(size_of::<DiffuseParticle>() == 32);
};

/// Their slots, a ring: the oldest are overwritten first.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DiffuseState {
    /// of PARTICLE\_GROUP that visit the slots in use: a VkDispatchIndirectCommand
    pub groups: [u32; 3],
    /// `uint`.
    pub next_slot: u32,
    /// a triangle for each slot in use: a VkDrawIndirectCommand
    pub vertex_count: u32,
    /// `uint`.
    pub instance_count: u32,
    /// `uint`.
    pub first_vertex: u32,
    /// `uint`.
    pub first_instance: u32,
}
const _: () = {
    assert!(offset_of!(DiffuseState, groups) == 0);
    assert!(offset_of!(DiffuseState, next_slot) == 12);
    assert!(offset_of!(DiffuseState, vertex_count) == 16);
    assert!(offset_of!(DiffuseState, instance_count) == 20);
    assert!(offset_of!(DiffuseState, first_vertex) == 24);
    assert!(offset_of!(DiffuseState, first_instance) == 28);
    assert!(size_of::<DiffuseState>() == 32);
};

/// What makes and moves them. Each potential is a quantity below the least of which nothing comes of it, and above whose range
/// no more: Phi(I, tau\_min, tau\_max), eq. (1).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DiffuseParams {
    /// `uint`.
    pub capacity: u32,
    /// k\_ta, eq. (8): of one fluid particle
    pub trapped_air_per_s: f32,
    /// k\_wc
    pub wave_crest_per_s: f32,
    /// `float`.
    pub lifetime_s: f32,
    /// `float`.
    pub trapped_air_least_m_s: f32,
    /// `float`.
    pub trapped_air_inverse_range_s_m: f32,
    /// `float`.
    pub wave_crest_least: f32,
    /// `float`.
    pub wave_crest_inverse_range: f32,
    /// `float`.
    pub energy_least_j_kg: f32,
    /// `float`.
    pub energy_inverse_range_kg_j: f32,
    /// k\_b, eq. (12): of gravity
    pub buoyancy: f32,
    /// k\_d, likewise: share of the fluid's velocity that a bubble takes on in a step
    pub drag: f32,
    /// over the neighbours of one with fluid all around
    pub inverse_neighbours: f32,
    /// over the sum of their weights 1 - r/h
    pub inverse_weight: f32,
    /// over the length of a flat surface's normal
    pub inverse_normal: f32,
    /// radius of the cylinder in which a fluid particle spawns them: what it keeps from walls
    pub spread_m: f32,
    /// that a pass stands for
    pub substeps: u32,
    /// 1; 0 in two dimensions
    pub along_z: f32,
    /// `float`.
    pub reserved0: f32,
    /// `float`.
    pub reserved1: f32,
}
const _: () = {
    assert!(offset_of!(DiffuseParams, capacity) == 0);
    assert!(offset_of!(DiffuseParams, trapped_air_per_s) == 4);
    assert!(offset_of!(DiffuseParams, wave_crest_per_s) == 8);
    assert!(offset_of!(DiffuseParams, lifetime_s) == 12);
    assert!(offset_of!(DiffuseParams, trapped_air_least_m_s) == 16);
    assert!(offset_of!(DiffuseParams, trapped_air_inverse_range_s_m) == 20);
    assert!(offset_of!(DiffuseParams, wave_crest_least) == 24);
    assert!(offset_of!(DiffuseParams, wave_crest_inverse_range) == 28);
    assert!(offset_of!(DiffuseParams, energy_least_j_kg) == 32);
    assert!(offset_of!(DiffuseParams, energy_inverse_range_kg_j) == 36);
    assert!(offset_of!(DiffuseParams, buoyancy) == 40);
    assert!(offset_of!(DiffuseParams, drag) == 44);
    assert!(offset_of!(DiffuseParams, inverse_neighbours) == 48);
    assert!(offset_of!(DiffuseParams, inverse_weight) == 52);
    assert!(offset_of!(DiffuseParams, inverse_normal) == 56);
    assert!(offset_of!(DiffuseParams, spread_m) == 60);
    assert!(offset_of!(DiffuseParams, substeps) == 64);
    assert!(offset_of!(DiffuseParams, along_z) == 68);
    assert!(offset_of!(DiffuseParams, reserved0) == 72);
    assert!(offset_of!(DiffuseParams, reserved1) == 76);
    assert!(size_of::<DiffuseParams>() == 80);
};

/// How they look.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DiffuseStyle {
    /// of one that is drawn
    pub radius_m: f32,
    /// optical depth at the middle of one
    pub opacity: f32,
    /// of the fluid: one less than this behind its surface is on it
    pub spacing_m: f32,
    /// before the end of its lifetime it fades for so long
    pub fade_s: f32,
}
const _: () = {
    assert!(offset_of!(DiffuseStyle, radius_m) == 0);
    assert!(offset_of!(DiffuseStyle, opacity) == 4);
    assert!(offset_of!(DiffuseStyle, spacing_m) == 8);
    assert!(offset_of!(DiffuseStyle, fade_s) == 12);
    assert!(size_of::<DiffuseStyle>() == 16);
};
