// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from emitters/layout.hlsli.
//! Host-visible structs of `emitters/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Emitters of a scene: a thread each.
pub const MAX_EMITTERS: u32 = 64;

/// Drains of a scene: each particle looks at all of them.
pub const MAX_DRAINS: u32 = 64;

/// What a drain's numbers mean.
pub const DRAIN_BOX: u32 = 0;

/// `DRAIN_SPHERE`.
pub const DRAIN_SPHERE: u32 = 1;

/// of a box
pub const DRAIN_OUTSIDE: u32 = 2;

/// A nozzle, which emits a layer of lattice points each time its flow moved a spacing; or a block of them, once.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Emitter {
    /// of the flow, in the nozzle's frame, of length 1
    pub direction: [f32; 3],
    /// `float`.
    pub speed_m_s: f32,
    /// of a layer, among those of all emitters
    pub first_point: u32,
    /// `uint`.
    pub points: u32,
    /// of its motion
    pub first_keyframe: u32,
    /// `uint`.
    pub keyframe_count: u32,
    /// after which keyframes begin again; 0: they end
    pub period_s: f32,
    /// `float`.
    pub start_s: f32,
    /// `float`.
    pub end_s: f32,
    /// of a particle; 0: for ever
    pub lifetime_s: f32,
    /// of its flow; 0: one at start\_s, and no other
    pub layers_per_m: f32,
    /// how far along each axis a particle may be from its lattice point
    pub jitter_m: f32,
    /// `uint`.
    pub fluid: u32,
    /// in a substep
    pub most_layers: u32,
    /// along the nozzle's width, of length 1, in its frame
    pub across: [f32; 3],
    /// its radius where it is round
    pub half_width_m: f32,
    /// along its height, likewise
    pub up: [f32; 3],
    /// 0: it is round
    pub half_height_m: f32,
}
const _: () = {
    assert!(offset_of!(Emitter, direction) == 0);
    assert!(offset_of!(Emitter, speed_m_s) == 12);
    assert!(offset_of!(Emitter, first_point) == 16);
    assert!(offset_of!(Emitter, points) == 20);
    assert!(offset_of!(Emitter, first_keyframe) == 24);
    assert!(offset_of!(Emitter, keyframe_count) == 28);
    assert!(offset_of!(Emitter, period_s) == 32);
    assert!(offset_of!(Emitter, start_s) == 36);
    assert!(offset_of!(Emitter, end_s) == 40);
    assert!(offset_of!(Emitter, lifetime_s) == 44);
    assert!(offset_of!(Emitter, layers_per_m) == 48);
    assert!(offset_of!(Emitter, jitter_m) == 52);
    assert!(offset_of!(Emitter, fluid) == 56);
    assert!(offset_of!(Emitter, most_layers) == 60);
    assert!(offset_of!(Emitter, across) == 64);
    assert!(offset_of!(Emitter, half_width_m) == 76);
    assert!(offset_of!(Emitter, up) == 80);
    assert!(offset_of!(Emitter, half_height_m) == 92);
    assert!(size_of::<Emitter>() == 96);
};

/// A point of a layer, in the nozzle's frame.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct EmitterPoint {
    /// `float3`.
    pub place_m: [f32; 3],
    /// `float`.
    pub reserved: f32,
}
const _: () = {
    assert!(offset_of!(EmitterPoint, place_m) == 0);
    assert!(offset_of!(EmitterPoint, reserved) == 12);
    assert!(size_of::<EmitterPoint>() == 16);
};

/// What lasts of an emitter from substep to substep.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct EmitterState {
    /// by its flow, in spacings, since half a spacing before the last layer; a layer is due at .5
    pub moved: f32,
    /// so far
    pub layers: u32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(EmitterState, moved) == 0);
    assert!(offset_of!(EmitterState, layers) == 4);
    assert!(offset_of!(EmitterState, reserved0) == 8);
    assert!(offset_of!(EmitterState, reserved1) == 12);
    assert!(size_of::<EmitterState>() == 16);
};

/// What an emitter does in a substep.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct EmitterFlow {
    /// of its frame, when the substep begins
    pub position_m: [f32; 3],
    /// of the nozzle is its oldest layer
    pub ahead_m: f32,
    /// `float4`.
    pub rotation: [f32; 4],
    /// of its frame, when the substep ends
    pub after_m: [f32; 3],
    /// of its particles among those of all emitters
    pub first: u32,
    /// `float4`.
    pub rotation_after: [f32; 4],
    /// `uint`.
    pub layers: u32,
    /// number of the oldest
    pub layer: u32,
    /// 1 while it does
    pub flows: u32,
    /// `uint`.
    pub reserved: u32,
}
const _: () = {
    assert!(offset_of!(EmitterFlow, position_m) == 0);
    assert!(offset_of!(EmitterFlow, ahead_m) == 12);
    assert!(offset_of!(EmitterFlow, rotation) == 16);
    assert!(offset_of!(EmitterFlow, after_m) == 32);
    assert!(offset_of!(EmitterFlow, first) == 44);
    assert!(offset_of!(EmitterFlow, rotation_after) == 48);
    assert!(offset_of!(EmitterFlow, layers) == 64);
    assert!(offset_of!(EmitterFlow, layer) == 68);
    assert!(offset_of!(EmitterFlow, flows) == 72);
    assert!(offset_of!(EmitterFlow, reserved) == 76);
    assert!(size_of::<EmitterFlow>() == 80);
};

/// What all of them do.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Emission {
    /// of PARTICLE\_GROUP that emit: a VkDispatchIndirectCommand
    pub groups: [u32; 3],
    /// slots
    pub claimed: u32,
    /// `uint`.
    pub first_slot: u32,
    /// when the last substep ended that was opened, as StepState has it
    pub time_s: f32,
    /// `float`.
    pub time_lost_s: f32,
    /// `uint`.
    pub reserved: u32,
}
const _: () = {
    assert!(offset_of!(Emission, groups) == 0);
    assert!(offset_of!(Emission, claimed) == 12);
    assert!(offset_of!(Emission, first_slot) == 16);
    assert!(offset_of!(Emission, time_s) == 20);
    assert!(offset_of!(Emission, time_lost_s) == 24);
    assert!(offset_of!(Emission, reserved) == 28);
    assert!(size_of::<Emission>() == 32);
};

/// `EmissionParams`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct EmissionParams {
    /// `uint`.
    pub emitters: u32,
    /// slots there are
    pub capacity: u32,
    /// `float`.
    pub spacing_m: f32,
    /// 1; 0 in two dimensions, where nothing is off the plane
    pub along_z: f32,
    /// so far before a nozzle particles have its velocity
    pub guide_m: f32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(EmissionParams, emitters) == 0);
    assert!(offset_of!(EmissionParams, capacity) == 4);
    assert!(offset_of!(EmissionParams, spacing_m) == 8);
    assert!(offset_of!(EmissionParams, along_z) == 12);
    assert!(offset_of!(EmissionParams, guide_m) == 16);
    assert!(offset_of!(EmissionParams, reserved0) == 20);
    assert!(offset_of!(EmissionParams, reserved1) == 24);
    assert!(offset_of!(EmissionParams, reserved2) == 28);
    assert!(size_of::<EmissionParams>() == 32);
};

/// A region that deactivates what enters.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Drain {
    /// a sphere's middle
    pub min_m: [f32; 3],
    /// `uint`.
    pub shape: u32,
    /// a sphere's radius along each axis
    pub max_m: [f32; 3],
    /// that it takes at most; of drains without a limit 0
    pub particles_per_s: f32,
}
const _: () = {
    assert!(offset_of!(Drain, min_m) == 0);
    assert!(offset_of!(Drain, shape) == 12);
    assert!(offset_of!(Drain, max_m) == 16);
    assert!(offset_of!(Drain, particles_per_s) == 28);
    assert!(size_of::<Drain>() == 32);
};

/// `DrainParams`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DrainParams {
    /// `uint`.
    pub drains: u32,
    /// 1 where no other stage of the solver counts them
    pub counts_ages: u32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(DrainParams, drains) == 0);
    assert!(offset_of!(DrainParams, counts_ages) == 4);
    assert!(offset_of!(DrainParams, reserved0) == 8);
    assert!(offset_of!(DrainParams, reserved1) == 12);
    assert!(size_of::<DrainParams>() == 16);
};

/// Of a drain with a limit: what it may still take.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DrainState {
    /// particles
    pub credit: f32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(DrainState, credit) == 0);
    assert!(offset_of!(DrainState, reserved0) == 4);
    assert!(offset_of!(DrainState, reserved1) == 8);
    assert!(offset_of!(DrainState, reserved2) == 12);
    assert!(size_of::<DrainState>() == 16);
};
