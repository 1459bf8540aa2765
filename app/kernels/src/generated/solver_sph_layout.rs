// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/layout.hlsli.
//! Host-visible structs of `solver/sph/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// The share of surface tension's stress that is the same in all directions: Lafaurie's 1, and a quarter more. At 1 particles of the
/// surface clump, which draw each other along it (the tensile instability); at 2 a drop swings a tenth too slowly.
pub const ISOTROPIC: f32 = 1.25;

/// The kernels of density, pressure and viscosity as polynomials of t = 1 - q and s = 1 - 2 q, each 0 where it would be
/// less, without unit (host: solver/sph/kernels.rs). Scaled so that on the initial lattice the density ratio is 1, an even
/// slope of pressure has its own gradient, and a parabola of velocities its own Laplacian.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SphKernels {
    /// of t^3, t^4, t^5, t^6
    pub density: [f32; 4],
    /// -W'/q: of t, t^2, t^3, t^4
    pub pressure: [f32; 4],
    /// of a difference of velocities in the Laplacian, likewise
    pub viscosity: [f32; 4],
    /// of s^3
    pub density_spline: f32,
    /// of the particle itself
    pub density_self: f32,
    /// of t^2 / q
    pub pressure_inverse: f32,
    /// of s^2 / q
    pub pressure_spline: f32,
    /// `float`.
    pub viscosity_inverse: f32,
    /// `float`.
    pub viscosity_spline: f32,
    /// of (1 - q^2)^2: -W'/q of the colour field's kernel, poly6, scaled as the pressure's
    pub tension: f32,
    /// `float`.
    pub reserved0: f32,
}
const _: () = {
    assert!(offset_of!(SphKernels, density) == 0);
    assert!(offset_of!(SphKernels, pressure) == 16);
    assert!(offset_of!(SphKernels, viscosity) == 32);
    assert!(offset_of!(SphKernels, density_spline) == 48);
    assert!(offset_of!(SphKernels, density_self) == 52);
    assert!(offset_of!(SphKernels, pressure_inverse) == 56);
    assert!(offset_of!(SphKernels, pressure_spline) == 60);
    assert!(offset_of!(SphKernels, viscosity_inverse) == 64);
    assert!(offset_of!(SphKernels, viscosity_spline) == 68);
    assert!(offset_of!(SphKernels, tension) == 72);
    assert!(offset_of!(SphKernels, reserved0) == 76);
    assert!(size_of::<SphKernels>() == 80);
};

/// A particle's velocity, and its pressure over the square of its density, as pairs gather them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct VelocityPressure {
    /// `float3`.
    pub velocity_m_s: [f32; 3],
    /// p / (rho0 (rho/rho0)^2)
    pub pressure_m2_s2: f32,
}
const _: () = {
    assert!(offset_of!(VelocityPressure, velocity_m_s) == 0);
    assert!(offset_of!(VelocityPressure, pressure_m2_s2) == 12);
    assert!(size_of::<VelocityPressure>() == 16);
};

/// The gradient of the colour field, 1 in the fluid and 0 outside, over the particle's position.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SurfaceNormal {
    /// 1/h; into the fluid
    pub normal: [f32; 3],
    /// `float`.
    pub length: f32,
}
const _: () = {
    assert!(offset_of!(SurfaceNormal, normal) == 0);
    assert!(offset_of!(SurfaceNormal, length) == 12);
    assert!(size_of::<SurfaceNormal>() == 16);
};

/// A particle's both, side by side: one binding fewer, of which the floor tier has eight.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct VelocityPressureNormal {
    /// `VelocityPressure`.
    pub flow: VelocityPressure,
    /// `SurfaceNormal`.
    pub surface: SurfaceNormal,
}
const _: () = {
    assert!(offset_of!(VelocityPressureNormal, flow) == 0);
    assert!(offset_of!(VelocityPressureNormal, surface) == 16);
    assert!(size_of::<VelocityPressureNormal>() == 32);
};

/// The terms. Pressures are over the rest density, m^2/s^2.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SphParams {
    /// k of p = k (rho - rho0): the square of the speed of sound
    pub stiffness_m2_s2: f32,
    /// gamma of Tait's equation; 1: linear
    pub exponent: f32,
    /// 0 where pressure is clamped, far below everything where not
    pub least_pressure_m2_s2: f32,
    /// kinematic
    pub viscosity_m2_s: f32,
    /// surface tension over the rest density, and over what the layers of a plane surface sum to
    pub tension_m3_s2: f32,
    /// in h; closer pairs part even below rest density
    pub separation: f32,
    /// the pressure of a pair at one point
    pub separation_m2_s2: f32,
    /// 1 over the pressure from which on walls bear all of the fluid's weight
    pub supported_per_m2_s2: f32,
    /// of what walls bear, so that the lattice's first layer is at rest
    pub borne_scale: f32,
    /// KickParams::end
    pub end_kick: f32,
    /// 1 where solids add to the density before it becomes a pressure (add\_solid\_density.compute)
    pub defers_pressure: u32,
    /// CompletedDensity's, of the length of the colour field's gradient
    pub surface_linear: f32,
    /// of its square
    pub surface_square: f32,
    /// of it that counts, 1/h: little more than a plane surface's
    pub most_normal: f32,
    /// `float`.
    pub reserved0: f32,
    /// `float`.
    pub reserved1: f32,
}
const _: () = {
    assert!(offset_of!(SphParams, stiffness_m2_s2) == 0);
    assert!(offset_of!(SphParams, exponent) == 4);
    assert!(offset_of!(SphParams, least_pressure_m2_s2) == 8);
    assert!(offset_of!(SphParams, viscosity_m2_s) == 12);
    assert!(offset_of!(SphParams, tension_m3_s2) == 16);
    assert!(offset_of!(SphParams, separation) == 20);
    assert!(offset_of!(SphParams, separation_m2_s2) == 24);
    assert!(offset_of!(SphParams, supported_per_m2_s2) == 28);
    assert!(offset_of!(SphParams, borne_scale) == 32);
    assert!(offset_of!(SphParams, end_kick) == 36);
    assert!(offset_of!(SphParams, defers_pressure) == 40);
    assert!(offset_of!(SphParams, surface_linear) == 44);
    assert!(offset_of!(SphParams, surface_square) == 48);
    assert!(offset_of!(SphParams, most_normal) == 52);
    assert!(offset_of!(SphParams, reserved0) == 56);
    assert!(offset_of!(SphParams, reserved1) == 60);
    assert!(size_of::<SphParams>() == 64);
};

/// What limits the substeps (Monaghan 1992; Morris, Fox & Zhu 1997; Brackbill, Kothe & Zemach 1992).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SphLimits {
    /// over the speed of sound and the fastest particle's
    pub cfl_m: f32,
    /// `float`.
    pub sound_m_s: f32,
    /// over the largest acceleration, under the root
    pub force_m: f32,
    /// least of the viscous and the surface tension's limit
    pub steady_s: f32,
    /// what a step advances
    pub step_s: f32,
    /// of a step, at most
    pub substeps: u32,
    /// that particles may move until they are listed anew
    pub list_reach_m: f32,
    /// `uint`.
    pub reserved0: u32,
    /// SearchGroups' cells, sums and sums\_of\_sums of a substep that lists
    pub scan_groups: [u32; 3],
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(SphLimits, cfl_m) == 0);
    assert!(offset_of!(SphLimits, sound_m_s) == 4);
    assert!(offset_of!(SphLimits, force_m) == 8);
    assert!(offset_of!(SphLimits, steady_s) == 12);
    assert!(offset_of!(SphLimits, step_s) == 16);
    assert!(offset_of!(SphLimits, substeps) == 20);
    assert!(offset_of!(SphLimits, list_reach_m) == 24);
    assert!(offset_of!(SphLimits, reserved0) == 28);
    assert!(offset_of!(SphLimits, scan_groups) == 32);
    assert!(offset_of!(SphLimits, reserved1) == 44);
    assert!(size_of::<SphLimits>() == 48);
};

/// What the substeps came to. Maxima are bits, which order as the positive numbers that they are do.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SphTimeStep {
    /// m/s, of the last substep
    pub max_speed_bits: u32,
    /// m/s^2
    pub max_acceleration_bits: u32,
    /// that the substep has to keep
    pub limit_s: f32,
    /// of the step, where the GPU chooses its substeps
    pub left_s: f32,
    /// `uint`.
    pub substeps_left: u32,
    /// that particles may have moved since they were listed
    pub drift_m: f32,
    /// `uint`.
    pub reserved1: u32,
    /// `uint`.
    pub reserved2: u32,
}
const _: () = {
    assert!(offset_of!(SphTimeStep, max_speed_bits) == 0);
    assert!(offset_of!(SphTimeStep, max_acceleration_bits) == 4);
    assert!(offset_of!(SphTimeStep, limit_s) == 8);
    assert!(offset_of!(SphTimeStep, left_s) == 12);
    assert!(offset_of!(SphTimeStep, substeps_left) == 16);
    assert!(offset_of!(SphTimeStep, drift_m) == 20);
    assert!(offset_of!(SphTimeStep, reserved1) == 24);
    assert!(offset_of!(SphTimeStep, reserved2) == 28);
    assert!(size_of::<SphTimeStep>() == 32);
};
