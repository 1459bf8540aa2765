// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/layout.hlsli.
//! Host-visible structs of `solver/pbf/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Cells along each side of what one group relaxes.
pub const COARSE_TILE: u32 = 8;

/// Units of a constraint in one: sums of integers do not depend on their order.
pub const CONSTRAINT_UNITS: u32 = 32768;

/// What lies beyond the ends of a coarse grid's axis: a wall, the other end, or nothing.
pub const COARSE_WALL: u32 = 0;

/// `COARSE_PERIODIC`.
pub const COARSE_PERIODIC: u32 = 1;

/// `COARSE_OPEN`.
pub const COARSE_OPEN: u32 = 2;

/// The particles of a coarse cell.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct CoarseCell {
    /// of their constraints, in 1/CONSTRAINT\_UNITS
    pub constraint_sum: i32,
    /// `uint`.
    pub particles: u32,
}
const _: () = {
    assert!(offset_of!(CoarseCell, constraint_sum) == 0);
    assert!(offset_of!(CoarseCell, particles) == 4);
    assert!(size_of::<CoarseCell>() == 8);
};

/// One level of the coarse grid, x fastest. A cell is 2^halvings finest ones wide; the last along an axis may be less.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct CoarseGridParams {
    /// `uint3`.
    pub cells: [u32; 3],
    /// `uint`.
    pub halvings: u32,
    /// `uint3`.
    pub finest_cells: [u32; 3],
    /// `uint`.
    pub sweeps: u32,
    /// of the finest cells; 0 along z in two dimensions
    pub inverse_cell_size_per_m: [f32; 3],
    /// what a unit of the multiplier leaves of the constraint
    pub mixing: f32,
    /// (M h / cell)^2 of the finest cells; 0 along z in two dimensions
    pub conductance: [f32; 3],
    /// of a finest cell that is full at rest
    pub particles_a_cell: f32,
    /// COARSE\_WALL, COARSE\_PERIODIC or COARSE\_OPEN
    pub ends: [u32; 3],
    /// a multiplier is no more
    pub most: f32,
    /// and no less
    pub least: f32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(CoarseGridParams, cells) == 0);
    assert!(offset_of!(CoarseGridParams, halvings) == 12);
    assert!(offset_of!(CoarseGridParams, finest_cells) == 16);
    assert!(offset_of!(CoarseGridParams, sweeps) == 28);
    assert!(offset_of!(CoarseGridParams, inverse_cell_size_per_m) == 32);
    assert!(offset_of!(CoarseGridParams, mixing) == 44);
    assert!(offset_of!(CoarseGridParams, conductance) == 48);
    assert!(offset_of!(CoarseGridParams, particles_a_cell) == 60);
    assert!(offset_of!(CoarseGridParams, ends) == 64);
    assert!(offset_of!(CoarseGridParams, most) == 76);
    assert!(offset_of!(CoarseGridParams, least) == 80);
    assert!(offset_of!(CoarseGridParams, reserved0) == 84);
    assert!(offset_of!(CoarseGridParams, reserved1) == 88);
    assert!(offset_of!(CoarseGridParams, reserved2) == 92);
    assert!(size_of::<CoarseGridParams>() == 96);
};
