// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/layout.hlsli.
//! Host-visible structs of `boundary/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// How walls keep the fluid (boundary/repel\_walls.compute).
pub const WALLS_BY_PENALTY: u32 = 0;

/// `WALLS_BY_DEFLECTION`.
pub const WALLS_BY_DEFLECTION: u32 = 1;

/// How one of the six drags the fluid along it (boundary/drag\_walls.compute).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct WallFace {
    /// its own, along it
    pub velocity_m_s: [f32; 3],
    /// twice the kinematic viscosity, scaled; 0 where the fluid may slip
    pub shear_m2_s: f32,
    /// c\_f of a shear stress of c\_f/2 rho v^2, scaled
    pub friction: f32,
    /// `float`.
    pub reserved0: f32,
    /// `float`.
    pub reserved1: f32,
    /// `float`.
    pub reserved2: f32,
}
const _: () = {
    assert!(offset_of!(WallFace, velocity_m_s) == 0);
    assert!(offset_of!(WallFace, shear_m2_s) == 12);
    assert!(offset_of!(WallFace, friction) == 16);
    assert!(offset_of!(WallFace, reserved0) == 20);
    assert!(offset_of!(WallFace, reserved1) == 24);
    assert!(offset_of!(WallFace, reserved2) == 28);
    assert!(size_of::<WallFace>() == 32);
};

/// `RepelParams`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct RepelParams {
    /// one of these
    pub model: u32,
    /// of a wall: half a spacing, where the lattice's first layer is
    pub reach_m: f32,
    /// of a penalty, over the particle's mass
    pub stiffness_per_s2: f32,
    /// `float`.
    pub damping_per_s: f32,
    /// of a deflection
    pub restitution: f32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(RepelParams, model) == 0);
    assert!(offset_of!(RepelParams, reach_m) == 4);
    assert!(offset_of!(RepelParams, stiffness_per_s2) == 8);
    assert!(offset_of!(RepelParams, damping_per_s) == 12);
    assert!(offset_of!(RepelParams, restitution) == 16);
    assert!(offset_of!(RepelParams, reserved0) == 20);
    assert!(offset_of!(RepelParams, reserved1) == 24);
    assert!(offset_of!(RepelParams, reserved2) == 28);
    assert!(size_of::<RepelParams>() == 32);
};
