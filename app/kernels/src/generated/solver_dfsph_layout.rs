// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/layout.hlsli.
//! Host-visible structs of `solver/dfsph/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// One of the two solves, in an iteration of it. Pressures are multipliers without unit: p dt^2 / (rho0 h^2). Residuals are
/// density ratios.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct PressureSolve {
    /// mean residual at which the iterations end
    pub tolerance: f32,
    /// weight of the residual
    pub step: f32,
    /// of what the iteration before added; 0 in the first
    pub momentum: f32,
    /// weight of the residual where the fluid is very compressed
    pub guarded_step: f32,
    /// of what a particle is thinner than at rest: by so much it may grow denser
    pub room_share: f32,
    /// of what it is denser: so much is to go
    pub excess_share: f32,
    /// of the last substep's pressures, with which the solve begins
    pub warm_share: f32,
    /// `uint`.
    pub most_iterations: u32,
    /// before which no residual ends it
    pub least_iterations: u32,
    /// 1; 0 of displacements, in which solids have no part
    pub solids_move: f32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(PressureSolve, tolerance) == 0);
    assert!(offset_of!(PressureSolve, step) == 4);
    assert!(offset_of!(PressureSolve, momentum) == 8);
    assert!(offset_of!(PressureSolve, guarded_step) == 12);
    assert!(offset_of!(PressureSolve, room_share) == 16);
    assert!(offset_of!(PressureSolve, excess_share) == 20);
    assert!(offset_of!(PressureSolve, warm_share) == 24);
    assert!(offset_of!(PressureSolve, most_iterations) == 28);
    assert!(offset_of!(PressureSolve, least_iterations) == 32);
    assert!(offset_of!(PressureSolve, solids_move) == 36);
    assert!(offset_of!(PressureSolve, reserved1) == 40);
    assert!(offset_of!(PressureSolve, reserved2) == 44);
    assert!(size_of::<PressureSolve>() == 48);
};

/// How far a solve is. Zero groups, and the iterations that are left do nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SolveState {
    /// of an iteration's stages: a VkDispatchIndirectCommand
    pub groups: [u32; 3],
    /// done
    pub iterations: u32,
    /// mean over the particles before the iteration that was looked at last
    pub residual: f32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(SolveState, groups) == 0);
    assert!(offset_of!(SolveState, iterations) == 12);
    assert!(offset_of!(SolveState, residual) == 16);
    assert!(offset_of!(SolveState, reserved0) == 20);
    assert!(offset_of!(SolveState, reserved1) == 24);
    assert!(offset_of!(SolveState, reserved2) == 28);
    assert!(size_of::<SolveState>() == 32);
};

/// What of a particle the iterations ask again and again.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct PressureFactors {
    /// boundary/mirror.hlsli, h
    pub from_walls: [f32; 3],
    /// density ratio - 1
    pub excess: f32,
    /// 0 of what takes no part
    pub inverse_stiffness: f32,
    /// out of the half-space that stands for the solids near it, packed (boundary/mirror.hlsli)
    pub solid_normal: u32,
    /// h, signed; NO\_WALL where there is none
    pub from_solids: f32,
    /// of that half-space along its normal
    pub solid_speed_m_s: f32,
}
const _: () = {
    assert!(offset_of!(PressureFactors, from_walls) == 0);
    assert!(offset_of!(PressureFactors, excess) == 12);
    assert!(offset_of!(PressureFactors, inverse_stiffness) == 16);
    assert!(offset_of!(PressureFactors, solid_normal) == 20);
    assert!(offset_of!(PressureFactors, from_solids) == 24);
    assert!(offset_of!(PressureFactors, solid_speed_m_s) == 28);
    assert!(size_of::<PressureFactors>() == 32);
};
