// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from shared/layout.hlsli.
//! Host-visible structs of `shared/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Vulkan promises 65,535 groups an axis only, so longer dispatches are folded into rows of so many.
pub const GROUPS_PER_ROW: u32 = 32768;

/// Values each thread of a scan takes.
pub const SCAN_ITEMS: u32 = 16;

/// Particles whose neighbour lists lie interleaved: a group.
pub const LIST_SLICE: u32 = 64;

/// Neighbours of a particle that lie side by side: one 8-byte load.
pub const LIST_CHUNK: u32 = 4;

/// A neighbour's delta that stands for nobody, and how far it moves on: half of what 16 bits hold, so that a row of
/// candidates that begins within it ends within 16 bits.
pub const LIST_ESCAPE: u32 = 0;

/// `LIST_ESCAPE_DELTA`.
pub const LIST_ESCAPE_DELTA: u32 = 32768;

/// Candidates that a search for neighbours looks at, at most: forty times those of fluid at rest. With all
/// particles in one cell it would take their number squared, which no driver's watchdog waits for.
pub const MAX_CANDIDATES: u32 = 2048;

/// Bins of a histogram, 32 to an octave.
pub const HISTOGRAM_BINS: u32 = 512;

/// The bit of Position::tag that parks a particle whose state is not finite.
pub const QUARANTINED: u32 = 0x80000000;

/// Where the fluid's number begins in Position::tag; the id lies below.
pub const FLUID_SHIFT: u32 = 24;

/// The fluid's number that says that a slot is inactive.
pub const INACTIVE_FLUID: u32 = 127;

/// A particle where it is, and which one it is.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Position {
    /// `float3`.
    pub position_m: [f32; 3],
    /// bits 0-23 id, 24-30 fluid (127: an inactive slot), 31 quarantined
    pub tag: u32,
}
const _: () = {
    assert!(offset_of!(Position, position_m) == 0);
    assert!(offset_of!(Position, tag) == 12);
    assert!(size_of::<Position>() == 16);
};

/// A particle's quantized position (shared/quantized\_position.hlsli) during an iteration, with its constraint's lambda.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct PositionLambda {
    /// `uint2`.
    pub quantized_position: [u32; 2],
    /// Macklin & Muller 2013, eq. (11), times h^2: no unit
    pub lambda: f32,
    /// of the lambdas before it, where they accumulate
    pub total: f32,
}
const _: () = {
    assert!(offset_of!(PositionLambda, quantized_position) == 0);
    assert!(offset_of!(PositionLambda, lambda) == 8);
    assert!(offset_of!(PositionLambda, total) == 12);
    assert!(size_of::<PositionLambda>() == 16);
};

/// `Velocity`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Velocity {
    /// `float3`.
    pub velocity_m_s: [f32; 3],
    /// since the particle began, where the solver counts it; below 0: what is left of its lifetime
    pub age_s: f32,
}
const _: () = {
    assert!(offset_of!(Velocity, velocity_m_s) == 0);
    assert!(offset_of!(Velocity, age_s) == 12);
    assert!(size_of::<Velocity>() == 16);
};

/// Curl of the velocity field and its length, 1/s.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Vorticity {
    /// `float3`.
    pub vorticity_per_s: [f32; 3],
    /// `float`.
    pub magnitude_per_s: f32,
}
const _: () = {
    assert!(offset_of!(Vorticity, vorticity_per_s) == 0);
    assert!(offset_of!(Vorticity, magnitude_per_s) == 12);
    assert!(size_of::<Vorticity>() == 16);
};

/// Where the counting sort puts a particle: its cell, and how many came before it in that cell.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct CellSlot {
    /// `uint`.
    pub cell: u32,
    /// `uint`.
    pub rank: u32,
}
const _: () = {
    assert!(offset_of!(CellSlot, cell) == 0);
    assert!(offset_of!(CellSlot, rank) == 4);
    assert!(size_of::<CellSlot>() == 8);
};

/// How a particle's neighbour list begins (shared/list.hlsli).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct ListHead {
    /// neighbours, and deltas too wide for one
    pub entries: u32,
    /// sorted index that the first neighbour's delta is counted from, plus 1
    pub first: u32,
}
const _: () = {
    assert!(offset_of!(ListHead, entries) == 0);
    assert!(offset_of!(ListHead, first) == 4);
    assert!(size_of::<ListHead>() == 8);
};

/// One substep.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct StepParams {
    /// `float3`.
    pub gravity_m_s2: [f32; 3],
    /// that substeps are to take: StepState has the one they take
    pub dt_s: f32,
    /// `float3`.
    pub domain_size_m: [f32; 3],
    /// particles stay at least this far from a wall
    pub wall_offset_m: f32,
    /// where walls stand; too far to matter along axes that have none
    pub wall_min_m: [f32; 3],
    /// `float`.
    pub max_speed_m_s: f32,
    /// `float3`.
    pub wall_max_m: [f32; 3],
    /// whether walls count as the solver counts them: 1 as mirrors, 0 by their wall-weight function
    pub mirrors: u32,
    /// the domain's side along axes that are periodic, 0 along others
    pub period_m: [f32; 3],
    /// room for neighbours a particle, in LIST\_CHUNKs
    pub list_chunks: u32,
    /// 0 along axes that are not
    pub inverse_period_per_m: [f32; 3],
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(StepParams, gravity_m_s2) == 0);
    assert!(offset_of!(StepParams, dt_s) == 12);
    assert!(offset_of!(StepParams, domain_size_m) == 16);
    assert!(offset_of!(StepParams, wall_offset_m) == 28);
    assert!(offset_of!(StepParams, wall_min_m) == 32);
    assert!(offset_of!(StepParams, max_speed_m_s) == 44);
    assert!(offset_of!(StepParams, wall_max_m) == 48);
    assert!(offset_of!(StepParams, mirrors) == 60);
    assert!(offset_of!(StepParams, period_m) == 64);
    assert!(offset_of!(StepParams, list_chunks) == 76);
    assert!(offset_of!(StepParams, inverse_period_per_m) == 80);
    assert!(offset_of!(StepParams, reserved1) == 92);
    assert!(size_of::<StepParams>() == 96);
};

/// What only the GPU may know of a substep; the host uploads it with particles alone. What is visited in a
/// dispatch or a draw whose size the host does not know is said in the form of Vulkan's indirect commands.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct StepState {
    /// slots that the substep visits: no particle stands behind them
    pub slot_count: u32,
    /// particles, quarantined ones too, as the last sort counted; inactive slots stand behind
    pub active_count: u32,
    /// of the substep
    pub dt_s: f32,
    /// simulated when the substep ends
    pub time_s: f32,
    /// groups of PARTICLE\_GROUP that visit the slots: a VkDispatchIndirectCommand
    pub slot_groups: [u32; 3],
    /// what rounding has taken from time\_s (Kahan 1965)
    pub time_lost_s: f32,
    /// a triangle for each slot: a VkDrawIndirectCommand
    pub vertex_count: u32,
    /// `uint`.
    pub instance_count: u32,
    /// `uint`.
    pub first_vertex: u32,
    /// `uint`.
    pub first_instance: u32,
}
const _: () = {
    assert!(offset_of!(StepState, slot_count) == 0);
    assert!(offset_of!(StepState, active_count) == 4);
    assert!(offset_of!(StepState, dt_s) == 8);
    assert!(offset_of!(StepState, time_s) == 12);
    assert!(offset_of!(StepState, slot_groups) == 16);
    assert!(offset_of!(StepState, time_lost_s) == 28);
    assert!(offset_of!(StepState, vertex_count) == 32);
    assert!(offset_of!(StepState, instance_count) == 36);
    assert!(offset_of!(StepState, first_vertex) == 40);
    assert!(offset_of!(StepState, first_instance) == 44);
    assert!(size_of::<StepState>() == 48);
};

/// The neighbour grid, x fastest: a cell for each of the domain's, or, in a domain far larger than its
/// fluid (WRAPPED), powers of two that the domain's cells are wrapped onto. Cell `cell_count` holds
/// what is outside or quarantined, which is nobody's neighbour; the one behind it holds inactive slots.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct GridParams {
    /// `uint3`.
    pub cells: [u32; 3],
    /// cells.x \* cells.y \* cells.z
    pub cell_count: u32,
    /// `float`.
    pub cell_size_m: f32,
    /// `float`.
    pub inverse_cell_size_per_m: f32,
    /// h: the kernel is zero beyond it
    pub support_m: f32,
    /// `float`.
    pub inverse_support_per_m: f32,
    /// `uint3`.
    pub domain_cells: [u32; 3],
    /// room for neighbours a particle, in LIST\_CHUNKs
    pub list_chunks: u32,
    /// the domain's cells along axes that are periodic, more than it has along others
    pub seam_cells: [u32; 3],
    /// `uint`.
    pub reserved: u32,
}
const _: () = {
    assert!(offset_of!(GridParams, cells) == 0);
    assert!(offset_of!(GridParams, cell_count) == 12);
    assert!(offset_of!(GridParams, cell_size_m) == 16);
    assert!(offset_of!(GridParams, inverse_cell_size_per_m) == 20);
    assert!(offset_of!(GridParams, support_m) == 24);
    assert!(offset_of!(GridParams, inverse_support_per_m) == 28);
    assert!(offset_of!(GridParams, domain_cells) == 32);
    assert!(offset_of!(GridParams, list_chunks) == 44);
    assert!(offset_of!(GridParams, seam_cells) == 48);
    assert!(offset_of!(GridParams, reserved) == 60);
    assert!(size_of::<GridParams>() == 64);
};

/// Groups of the dispatches of a sort and of its lists, a VkDispatchIndirectCommand each, where the GPU says which substeps
/// sort: none of a substep that keeps order and lists.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SearchGroups {
    /// that count particles, move them and list their neighbours
    pub slots: [u32; 3],
    /// `uint`.
    pub reserved0: u32,
    /// of those that stay in their order (keep\_order.compute)
    pub kept_slots: [u32; 3],
    /// `uint`.
    pub reserved1: u32,
    /// that sum up and scan what cells hold
    pub cells: [u32; 3],
    /// `uint`.
    pub reserved2: u32,
    /// likewise, of those groups' sums
    pub sums: [u32; 3],
    /// `uint`.
    pub reserved3: u32,
    /// `uint3`.
    pub sums_of_sums: [u32; 3],
    /// `uint`.
    pub reserved4: u32,
}
const _: () = {
    assert!(offset_of!(SearchGroups, slots) == 0);
    assert!(offset_of!(SearchGroups, reserved0) == 12);
    assert!(offset_of!(SearchGroups, kept_slots) == 16);
    assert!(offset_of!(SearchGroups, reserved1) == 28);
    assert!(offset_of!(SearchGroups, cells) == 32);
    assert!(offset_of!(SearchGroups, reserved2) == 44);
    assert!(offset_of!(SearchGroups, sums) == 48);
    assert!(offset_of!(SearchGroups, reserved3) == 60);
    assert!(offset_of!(SearchGroups, sums_of_sums) == 64);
    assert!(offset_of!(SearchGroups, reserved4) == 76);
    assert!(size_of::<SearchGroups>() == 80);
};

/// The smoothing kernel, Wendland C2, scaled so that the initial lattice has density ratio 1, and
/// what it counts beyond walls (boundary/walls.hlsli).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SmoothingKernelParams {
    /// `float`.
    pub support_m: f32,
    /// `float`.
    pub inverse_support_per_m: f32,
    /// 1 / sum of W over the lattice, W(0) = 1
    pub weight: f32,
    /// density ratio of all space, as one wall's share of it counts
    pub wall_plane: f32,
    /// of two walls' product
    pub wall_edge: f32,
    /// of three walls'
    pub wall_corner: f32,
    /// 1; 0 in two dimensions, where nothing moves along z
    pub along_z: f32,
    /// `float`.
    pub reserved: f32,
    /// the kernel's share beyond a wall that it reaches by t: t^5 times this polynomial of t
    pub wall_kernel_fraction: [f32; 4],
}
const _: () = {
    assert!(offset_of!(SmoothingKernelParams, support_m) == 0);
    assert!(offset_of!(SmoothingKernelParams, inverse_support_per_m) == 4);
    assert!(offset_of!(SmoothingKernelParams, weight) == 8);
    assert!(offset_of!(SmoothingKernelParams, wall_plane) == 12);
    assert!(offset_of!(SmoothingKernelParams, wall_edge) == 16);
    assert!(offset_of!(SmoothingKernelParams, wall_corner) == 20);
    assert!(offset_of!(SmoothingKernelParams, along_z) == 24);
    assert!(offset_of!(SmoothingKernelParams, reserved) == 28);
    assert!(offset_of!(SmoothingKernelParams, wall_kernel_fraction) == 32);
    assert!(size_of::<SmoothingKernelParams>() == 48);
};

/// Position Based Fluids, Macklin & Muller 2013. Lengths in units of h where no unit is named.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct PbfParams {
    /// of a correction: Jacobi under-relaxation, or 1 where lambda has it (PbfIteration)
    pub relaxation: f32,
    /// constraint force mixing, in units of |grad C|^2 h^2
    pub cfm: f32,
    /// artificial pressure, eq. (13)
    pub s_corr_k: f32,
    /// 1 / W(dq)
    pub s_corr_inverse_w: f32,
    /// an iteration moves a particle no further
    pub max_correction_m: f32,
    /// two particles closer than this part even below rest density
    pub separation: f32,
    /// what is added to their lambdas at one point
    pub separation_lambda: f32,
    /// share of the last substep's pressure that the next one begins with
    pub warm_start: f32,
}
const _: () = {
    assert!(offset_of!(PbfParams, relaxation) == 0);
    assert!(offset_of!(PbfParams, cfm) == 4);
    assert!(offset_of!(PbfParams, s_corr_k) == 8);
    assert!(offset_of!(PbfParams, s_corr_inverse_w) == 12);
    assert!(offset_of!(PbfParams, max_correction_m) == 16);
    assert!(offset_of!(PbfParams, separation) == 20);
    assert!(offset_of!(PbfParams, separation_lambda) == 24);
    assert!(offset_of!(PbfParams, warm_start) == 28);
    assert!(size_of::<PbfParams>() == 32);
};

/// What the corrections of a substep came to, for the next one to begin with (solver/pbf/start\_warm.compute).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct WarmStart {
    /// `float3`.
    pub acceleration_m_s2: [f32; 3],
    /// all of its lambdas, over dt^2 as the acceleration is
    pub multiplier_per_s2: f32,
}
const _: () = {
    assert!(offset_of!(WarmStart, acceleration_m_s2) == 0);
    assert!(offset_of!(WarmStart, multiplier_per_s2) == 12);
    assert!(size_of::<WarmStart>() == 16);
};

/// How an integrator splits the acceleration of a substep around its move (particles/advect.compute): the share of dt
/// that velocities take of it before the move, after it, and when it is computed. They add up to 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct KickParams {
    /// `float`.
    pub before: f32,
    /// `float`.
    pub after: f32,
    /// `float`.
    pub end: f32,
    /// `float`.
    pub reserved: f32,
}
const _: () = {
    assert!(offset_of!(KickParams, before) == 0);
    assert!(offset_of!(KickParams, after) == 4);
    assert!(offset_of!(KickParams, end) == 8);
    assert!(offset_of!(KickParams, reserved) == 12);
    assert!(size_of::<KickParams>() == 16);
};

/// One of the iterations of a substep whose lambdas have momentum (solver/pbf/momentum.hlsli).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct PbfIteration {
    /// weight of the constraint
    pub step: f32,
    /// of the particle's lambda of the iteration before; 0 in the first
    pub momentum: f32,
    /// weight of the constraint where the fluid is very compressed
    pub guarded_step: f32,
    /// 1 of the first iteration, unless a warm start wrote what stands before it
    pub begins_cold: u32,
}
const _: () = {
    assert!(offset_of!(PbfIteration, step) == 0);
    assert!(offset_of!(PbfIteration, momentum) == 4);
    assert!(offset_of!(PbfIteration, guarded_step) == 8);
    assert!(offset_of!(PbfIteration, begins_cold) == 12);
    assert!(size_of::<PbfIteration>() == 16);
};

/// What acts on velocities alone, whichever solver there is.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct ForceParams {
    /// XSPH viscosity, Macklin & Muller 2013, eq. (17)
    pub xsph: f32,
    /// vorticity confinement, eq. (16)
    pub vorticity_m_s: f32,
    /// `float`.
    pub reserved0: f32,
    /// `float`.
    pub reserved1: f32,
}
const _: () = {
    assert!(offset_of!(ForceParams, xsph) == 0);
    assert!(offset_of!(ForceParams, vorticity_m_s) == 4);
    assert!(offset_of!(ForceParams, reserved0) == 8);
    assert!(offset_of!(ForceParams, reserved1) == 12);
    assert!(size_of::<ForceParams>() == 16);
};

/// A body force of place and time (forces/apply\_fields.compute).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct ForceField {
    /// everywhere alike
    pub acceleration_m_s2: [f32; 3],
    /// that it swings with; 0: steady
    pub frequency_hz: f32,
    /// around the centre: swirl x (x - centre)
    pub swirl_per_s2: [f32; 3],
    /// `float`.
    pub begin_s: f32,
    /// `float3`.
    pub centre_m: [f32; 3],
    /// `float`.
    pub end_s: f32,
}
const _: () = {
    assert!(offset_of!(ForceField, acceleration_m_s2) == 0);
    assert!(offset_of!(ForceField, frequency_hz) == 12);
    assert!(offset_of!(ForceField, swirl_per_s2) == 16);
    assert!(offset_of!(ForceField, begin_s) == 28);
    assert!(offset_of!(ForceField, centre_m) == 32);
    assert!(offset_of!(ForceField, end_s) == 44);
    assert!(size_of::<ForceField>() == 48);
};

/// `ForceFieldCount`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct ForceFieldCount {
    /// `uint`.
    pub fields: u32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(ForceFieldCount, fields) == 0);
    assert!(offset_of!(ForceFieldCount, reserved0) == 4);
    assert!(offset_of!(ForceFieldCount, reserved1) == 8);
    assert!(offset_of!(ForceFieldCount, reserved2) == 12);
    assert!(size_of::<ForceFieldCount>() == 16);
};

/// What is counted rather than hidden. Each is a sum since it was last cleared.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Counters {
    /// neighbours that had no slot
    pub neighbour_overflow: u32,
    /// `uint`.
    pub speed_clamps: u32,
    /// `uint`.
    pub correction_clamps: u32,
    /// that iterations would have moved by a support radius or more
    pub displacement_clamps: u32,
    /// particles around which not all candidates were looked at
    pub crowded: u32,
    /// particles that were to be activated when no slot was left
    pub capacity_overflow: u32,
    /// that were longer than an explicit solver's limit
    pub long_substeps: u32,
    /// particles that emitters put into slots
    pub emitted: u32,
    /// of pressure solves that end by their residual: that hold the density
    pub density_iterations: u32,
    /// and that hold its change
    pub divergence_iterations: u32,
    /// such solves that did all iterations there were and had a residual left above tolerance
    pub unsolved: u32,
    /// particles whose slots drains emptied, or the end of their lifetime did
    pub drained: u32,
    /// diffuse particles (diffuse/layout.hlsli): that took a slot
    pub diffuse_spawned: u32,
    /// whose lifetime was over, or that left an open domain
    pub diffuse_ended: u32,
    /// that younger ones took the slot of while they were there
    pub diffuse_overwritten: u32,
    /// that were due when no slot was left in the step
    pub diffuse_dropped: u32,
}
const _: () = {
    assert!(offset_of!(Counters, neighbour_overflow) == 0);
    assert!(offset_of!(Counters, speed_clamps) == 4);
    assert!(offset_of!(Counters, correction_clamps) == 8);
    assert!(offset_of!(Counters, displacement_clamps) == 12);
    assert!(offset_of!(Counters, crowded) == 16);
    assert!(offset_of!(Counters, capacity_overflow) == 20);
    assert!(offset_of!(Counters, long_substeps) == 24);
    assert!(offset_of!(Counters, emitted) == 28);
    assert!(offset_of!(Counters, density_iterations) == 32);
    assert!(offset_of!(Counters, divergence_iterations) == 36);
    assert!(offset_of!(Counters, unsolved) == 40);
    assert!(offset_of!(Counters, drained) == 44);
    assert!(offset_of!(Counters, diffuse_spawned) == 48);
    assert!(offset_of!(Counters, diffuse_ended) == 52);
    assert!(offset_of!(Counters, diffuse_overwritten) == 56);
    assert!(offset_of!(Counters, diffuse_dropped) == 60);
    assert!(size_of::<Counters>() == 64);
};

/// Sums and extremes of one group of particles; the last stage reduces them to one of these.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MeasureSums {
    /// of |rho/rho0 - 1|
    pub density_error_sum: f32,
    /// `float`.
    pub density_error_max: f32,
    /// of max(rho/rho0 - 1, 0)
    pub compression_sum: f32,
    /// `float`.
    pub compression_max: f32,
    /// `float3`.
    pub position_sum_m: [f32; 3],
    /// largest x
    pub front_m: f32,
    /// `float3`.
    pub velocity_sum_m_s: [f32; 3],
    /// `float`.
    pub speed_max_m_s: f32,
    /// `float`.
    pub speed_squared_sum_m2_s2: f32,
    /// that were measured
    pub particles: u32,
    /// `uint`.
    pub quarantined: u32,
    /// outside an open domain
    pub escaped: u32,
}
const _: () = {
    assert!(offset_of!(MeasureSums, density_error_sum) == 0);
    assert!(offset_of!(MeasureSums, density_error_max) == 4);
    assert!(offset_of!(MeasureSums, compression_sum) == 8);
    assert!(offset_of!(MeasureSums, compression_max) == 12);
    assert!(offset_of!(MeasureSums, position_sum_m) == 16);
    assert!(offset_of!(MeasureSums, front_m) == 28);
    assert!(offset_of!(MeasureSums, velocity_sum_m_s) == 32);
    assert!(offset_of!(MeasureSums, speed_max_m_s) == 44);
    assert!(offset_of!(MeasureSums, speed_squared_sum_m2_s2) == 48);
    assert!(offset_of!(MeasureSums, particles) == 52);
    assert!(offset_of!(MeasureSums, quarantined) == 56);
    assert!(offset_of!(MeasureSums, escaped) == 60);
    assert!(size_of::<MeasureSums>() == 64);
};

/// What a measurement gives back to the host.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Measure {
    /// `MeasureSums`.
    pub sums: MeasureSums,
    /// `float`.
    pub density_error_p99: f32,
    /// `float`.
    pub compression_p99: f32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
    /// `Counters`.
    pub counters: Counters,
}
const _: () = {
    assert!(offset_of!(Measure, sums) == 0);
    assert!(offset_of!(Measure, density_error_p99) == 64);
    assert!(offset_of!(Measure, compression_p99) == 68);
    assert!(offset_of!(Measure, reserved0) == 72);
    assert!(offset_of!(Measure, reserved1) == 76);
    assert!(offset_of!(Measure, counters) == 80);
    assert!(size_of::<Measure>() == 144);
};

/// A drag through the fluid: what is near a ray is drawn toward a velocity.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DragParams {
    /// of the ray
    pub origin_m: [f32; 3],
    /// nothing beyond it is touched
    pub radius_m: f32,
    /// of the ray, of length 1
    pub direction: [f32; 3],
    /// of the way to the velocity that is made up on the ray itself, 0 to 1
    pub share: f32,
    /// `float3`.
    pub velocity_m_s: [f32; 3],
    /// 1; 0 in two dimensions, where nothing moves along z
    pub along_z: f32,
    /// nothing before this distance along the ray is touched
    pub near_m: f32,
    /// nor behind this one
    pub far_m: f32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(DragParams, origin_m) == 0);
    assert!(offset_of!(DragParams, radius_m) == 12);
    assert!(offset_of!(DragParams, direction) == 16);
    assert!(offset_of!(DragParams, share) == 28);
    assert!(offset_of!(DragParams, velocity_m_s) == 32);
    assert!(offset_of!(DragParams, along_z) == 44);
    assert!(offset_of!(DragParams, near_m) == 48);
    assert!(offset_of!(DragParams, far_m) == 52);
    assert!(offset_of!(DragParams, reserved0) == 56);
    assert!(offset_of!(DragParams, reserved1) == 60);
    assert!(size_of::<DragParams>() == 64);
};

/// A block of particles to activate, on a lattice.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct ActivateParams {
    /// the particle at the block's lowest corner
    pub first_m: [f32; 3],
    /// `float`.
    pub spacing_m: f32,
    /// `float3`.
    pub velocity_m_s: [f32; 3],
    /// `uint`.
    pub fluid: u32,
    /// particles along each axis; any 0: none
    pub counts: [u32; 3],
    /// slots there are
    pub capacity: u32,
}
const _: () = {
    assert!(offset_of!(ActivateParams, first_m) == 0);
    assert!(offset_of!(ActivateParams, spacing_m) == 12);
    assert!(offset_of!(ActivateParams, velocity_m_s) == 16);
    assert!(offset_of!(ActivateParams, fluid) == 28);
    assert!(offset_of!(ActivateParams, counts) == 32);
    assert!(offset_of!(ActivateParams, capacity) == 44);
    assert!(size_of::<ActivateParams>() == 48);
};

/// A box whose particles are deactivated.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DeactivateParams {
    /// `float3`.
    pub min_m: [f32; 3],
    /// `uint`.
    pub reserved0: u32,
    /// below min\_m: none
    pub max_m: [f32; 3],
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(DeactivateParams, min_m) == 0);
    assert!(offset_of!(DeactivateParams, reserved0) == 12);
    assert!(offset_of!(DeactivateParams, max_m) == 16);
    assert!(offset_of!(DeactivateParams, reserved1) == 28);
    assert!(size_of::<DeactivateParams>() == 32);
};

/// Which particles a capture keeps.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SampleParams {
    /// those whose id is a multiple of it
    pub stride: u32,
    /// ids are below it
    pub capacity: u32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(SampleParams, stride) == 0);
    assert!(offset_of!(SampleParams, capacity) == 4);
    assert!(offset_of!(SampleParams, reserved0) == 8);
    assert!(offset_of!(SampleParams, reserved1) == 12);
    assert!(size_of::<SampleParams>() == 16);
};
