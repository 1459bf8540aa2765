// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/bodies/layout.hlsli.
//! Host-visible structs of `boundary/bodies/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Bodies of a scene: a thread each of one group.
pub const MAX_BODIES: u32 = 64;

/// The number of what is no body.
pub const NO_BODY: u32 = 4294967295;

/// What a point of a body's surface touches, at most.
pub const CONTACTS_PER_POINT: u32 = 4;

/// Words of a body's reaction: three components of an impulse, three of its moment, 64 bits each, low words first; then how
/// many times particles pushed. Those of bodies come first, and are taken by step\_bodies; then those of solids whose force is
/// measured, about the domain's corner, which nobody takes.
pub const REACTION_WORDS: u32 = 16;

/// A body: the solid that it is, its inertia, and what holds it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct RigidBody {
    /// in its solid's frame
    pub centre_of_mass_m: [f32; 3],
    /// `float`.
    pub inverse_mass_per_kg: f32,
    /// about that, in the frame: xx, yy, zz
    pub inertia_kg_m2: [f32; 3],
    /// of fluid that it takes along where it is all wet
    pub added_mass_kg: f32,
    /// of the same tensor: xy, yz, zx
    pub products_kg_m2: [f32; 3],
    /// share of its surface that one particle wets
    pub wet_per_push: f32,
    /// of the fluid that it takes along
    pub added_inertia_kg_m2: [f32; 3],
    /// `uint`.
    pub solid: u32,
    /// `float3`.
    pub added_products_kg_m2: [f32; 3],
    /// about its hinge; 0 of a body that is free
    pub hinge_inertia_kg_m2: f32,
    /// a place on its hinge
    pub hinge_m: [f32; 3],
    /// of fluid, about the hinge
    pub hinge_added_kg_m2: f32,
    /// as long as 1
    pub hinge_axis: [f32; 3],
    /// `float`.
    pub reserved0: f32,
    /// that place in the frame
    pub hinge_place_m: [f32; 3],
    /// `float`.
    pub reserved1: f32,
}
const _: () = {
    assert!(offset_of!(RigidBody, centre_of_mass_m) == 0);
    assert!(offset_of!(RigidBody, inverse_mass_per_kg) == 12);
    assert!(offset_of!(RigidBody, inertia_kg_m2) == 16);
    assert!(offset_of!(RigidBody, added_mass_kg) == 28);
    assert!(offset_of!(RigidBody, products_kg_m2) == 32);
    assert!(offset_of!(RigidBody, wet_per_push) == 44);
    assert!(offset_of!(RigidBody, added_inertia_kg_m2) == 48);
    assert!(offset_of!(RigidBody, solid) == 60);
    assert!(offset_of!(RigidBody, added_products_kg_m2) == 64);
    assert!(offset_of!(RigidBody, hinge_inertia_kg_m2) == 76);
    assert!(offset_of!(RigidBody, hinge_m) == 80);
    assert!(offset_of!(RigidBody, hinge_added_kg_m2) == 92);
    assert!(offset_of!(RigidBody, hinge_axis) == 96);
    assert!(offset_of!(RigidBody, reserved0) == 108);
    assert!(offset_of!(RigidBody, hinge_place_m) == 112);
    assert!(offset_of!(RigidBody, reserved1) == 124);
    assert!(size_of::<RigidBody>() == 128);
};

/// How a body moves; of a solid whose force is measured all of it 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct BodyState {
    /// of its centre of mass
    pub position_m: [f32; 3],
    /// `float`.
    pub reserved0: f32,
    /// of its frame: a quaternion (x, y, z, w)
    pub rotation: [f32; 4],
    /// `float3`.
    pub velocity_m_s: [f32; 3],
    /// `float`.
    pub reserved1: f32,
    /// `float3`.
    pub spin_rad_s: [f32; 3],
    /// `float`.
    pub reserved2: f32,
    /// what the fluid gave and it has not taken yet (boundary/bodies/step\_bodies.compute)
    pub owed_kg_m_s: [f32; 3],
    /// `float`.
    pub reserved3: f32,
    /// the same of angular momentum
    pub owed_kg_m2_s: [f32; 3],
    /// `float`.
    pub reserved4: f32,
}
const _: () = {
    assert!(offset_of!(BodyState, position_m) == 0);
    assert!(offset_of!(BodyState, reserved0) == 12);
    assert!(offset_of!(BodyState, rotation) == 16);
    assert!(offset_of!(BodyState, velocity_m_s) == 32);
    assert!(offset_of!(BodyState, reserved1) == 44);
    assert!(offset_of!(BodyState, spin_rad_s) == 48);
    assert!(offset_of!(BodyState, reserved2) == 60);
    assert!(offset_of!(BodyState, owed_kg_m_s) == 64);
    assert!(offset_of!(BodyState, reserved3) == 76);
    assert!(offset_of!(BodyState, owed_kg_m2_s) == 80);
    assert!(offset_of!(BodyState, reserved4) == 92);
    assert!(size_of::<BodyState>() == 96);
};

/// A ball on a body's surface, in its solid's frame: what it touches others with.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SurfacePoint {
    /// `float3`.
    pub place_m: [f32; 3],
    /// `float`.
    pub radius_m: f32,
    /// `uint`.
    pub body: u32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(SurfacePoint, place_m) == 0);
    assert!(offset_of!(SurfacePoint, radius_m) == 12);
    assert!(offset_of!(SurfacePoint, body) == 16);
    assert!(offset_of!(SurfacePoint, reserved0) == 20);
    assert!(offset_of!(SurfacePoint, reserved1) == 24);
    assert!(offset_of!(SurfacePoint, reserved2) == 28);
    assert!(size_of::<SurfacePoint>() == 32);
};

/// What a surface point touches.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct BodyContact {
    /// on the other's surface
    pub at_m: [f32; 3],
    /// between the two; negative where one is in the other
    pub gap_m: f32,
    /// towards the body
    pub normal: [f32; 3],
    /// NO\_BODY: no contact
    pub body: u32,
    /// of what is no body
    pub other_m_s: [f32; 3],
    /// body; NO\_BODY of walls and of solids that move as they are told
    pub other: u32,
    /// `float`.
    pub friction: f32,
    /// `float`.
    pub restitution: f32,
    /// `float`.
    pub reserved0: f32,
    /// `float`.
    pub reserved1: f32,
}
const _: () = {
    assert!(offset_of!(BodyContact, at_m) == 0);
    assert!(offset_of!(BodyContact, gap_m) == 12);
    assert!(offset_of!(BodyContact, normal) == 16);
    assert!(offset_of!(BodyContact, body) == 28);
    assert!(offset_of!(BodyContact, other_m_s) == 32);
    assert!(offset_of!(BodyContact, other) == 44);
    assert!(offset_of!(BodyContact, friction) == 48);
    assert!(offset_of!(BodyContact, restitution) == 52);
    assert!(offset_of!(BodyContact, reserved0) == 56);
    assert!(offset_of!(BodyContact, reserved1) == 60);
    assert!(size_of::<BodyContact>() == 64);
};

/// Which body is dragged, by which of its points and to where (boundary/bodies/drag\_body.compute).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct BodyDragParams {
    /// in its solid's frame
    pub grip_m: [f32; 3],
    /// NO\_BODY: none is
    pub body: u32,
    /// where the grip is drawn to
    pub target_m: [f32; 3],
    /// share of the grip's velocity that is left of it
    pub kept: f32,
    /// of the way to the target
    pub pull_per_s: f32,
    /// share of the body's spin that is left of it
    pub kept_spin: f32,
    /// the grip is made no faster
    pub most_m_s: f32,
    /// `uint`.
    pub reserved0: u32,
}
const _: () = {
    assert!(offset_of!(BodyDragParams, grip_m) == 0);
    assert!(offset_of!(BodyDragParams, body) == 12);
    assert!(offset_of!(BodyDragParams, target_m) == 16);
    assert!(offset_of!(BodyDragParams, kept) == 28);
    assert!(offset_of!(BodyDragParams, pull_per_s) == 32);
    assert!(offset_of!(BodyDragParams, kept_spin) == 36);
    assert!(offset_of!(BodyDragParams, most_m_s) == 40);
    assert!(offset_of!(BodyDragParams, reserved0) == 44);
    assert!(size_of::<BodyDragParams>() == 48);
};
