// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/layout.hlsli.
//! Host-visible structs of `surface/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// Radius of a drop of spray alone, over that of a particle among others.
pub const SPRAY_RADIUS: f32 = 0.42;

/// How far a particle's ellipsoid moves to its neighbours' mean (Yu & Turk 2013, lambda of eq. 6).
pub const SMOOTHED_CENTER: f32 = 0.9;

/// How far the neighbours' mean lies below a particle of a flat surface, over h (at h = 2 d). Moved by
/// that too the water would stand half a spacing lower than the particles are.
pub const FLAT_MEAN: f32 = 0.2;

/// Its longest axis over its shortest (their k\_r of eq. 15).
pub const MOST_STRETCH: f32 = 4.0;

/// Variances of neighbours count as at least this, over h^2: those of particles in one point.
pub const LEAST_VARIANCE: f32 = 1.0e-4;

/// CountCovered looks at one drawn pixel in so many along either side,
pub const COVERED_STRIDE: u32 = 4;

/// and a group of it at so many of those along either side.
pub const COVERED_GROUP: u32 = 8;

/// A particle's volume in SunVolume's counts: weights are kept to 1/128, and 2^24 particles in one cell fit.
pub const SUN_VOLUME_UNITS: u32 = 128;

/// What the ellipsoids are made from: the neighbours within `support_m`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct AnisotropyParams {
    /// `float`.
    pub support_m: f32,
    /// room for neighbours a particle, in LIST\_CHUNKs
    pub list_chunks: u32,
    /// `uint`.
    pub reserved0: u32,
    /// `uint`.
    pub reserved1: u32,
}
const _: () = {
    assert!(offset_of!(AnisotropyParams, support_m) == 0);
    assert!(offset_of!(AnisotropyParams, list_chunks) == 4);
    assert!(offset_of!(AnisotropyParams, reserved0) == 8);
    assert!(offset_of!(AnisotropyParams, reserved1) == 12);
    assert!(size_of::<AnisotropyParams>() == 16);
};

/// A particle's ellipsoid (surface/ellipsoid.hlsli).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Ellipsoid {
    /// `float3`.
    pub center_m: [f32; 3],
    /// of its particle: quarantined ones are not drawn
    pub tag: u32,
    /// symmetric 3 x 3, over the sphere: six f16
    pub stretch: [u32; 3],
    /// `uint`.
    pub reserved: u32,
}
const _: () = {
    assert!(offset_of!(Ellipsoid, center_m) == 0);
    assert!(offset_of!(Ellipsoid, tag) == 12);
    assert!(offset_of!(Ellipsoid, stretch) == 16);
    assert!(offset_of!(Ellipsoid, reserved) == 28);
    assert!(size_of::<Ellipsoid>() == 32);
};

/// A fluid's surface in screen space.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SurfaceParams {
    /// the walls' bounds: the fluid is cut off outside this box
    pub wall_min_m: [f32; 3],
    /// of a particle's sphere
    pub radius_m: f32,
    /// `float3`.
    pub wall_max_m: [f32; 3],
    /// radius of the disc on which a particle's volume counts as thickness
    pub thickness_radius_m: f32,
    /// thickness is kept in spacings: f16 then fits any scene's size
    pub spacing_m: f32,
    /// reach of the smoothing filters, two standard deviations
    pub smoothing_m: f32,
    /// the reach is clamped to this, so that a near camera has an end
    pub most_reach_px: f32,
    /// depths further apart than this are of different surfaces
    pub range_m: f32,
    /// what lies behind counts as this far behind (narrow range)
    pub clamp_m: f32,
    /// curvature flow of one iteration: time x diffusivity, one
    pub flow_m2: f32,
    /// a side of the grid that the sun sends its photons through
    pub photons: f32,
    /// reach of what smooths the surface that they meet
    pub sun_smoothing_m: f32,
}
const _: () = {
    assert!(offset_of!(SurfaceParams, wall_min_m) == 0);
    assert!(offset_of!(SurfaceParams, radius_m) == 12);
    assert!(offset_of!(SurfaceParams, wall_max_m) == 16);
    assert!(offset_of!(SurfaceParams, thickness_radius_m) == 28);
    assert!(offset_of!(SurfaceParams, spacing_m) == 32);
    assert!(offset_of!(SurfaceParams, smoothing_m) == 36);
    assert!(offset_of!(SurfaceParams, most_reach_px) == 40);
    assert!(offset_of!(SurfaceParams, range_m) == 44);
    assert!(offset_of!(SurfaceParams, clamp_m) == 48);
    assert!(offset_of!(SurfaceParams, flow_m2) == 52);
    assert!(offset_of!(SurfaceParams, photons) == 56);
    assert!(offset_of!(SurfaceParams, sun_smoothing_m) == 60);
    assert!(size_of::<SurfaceParams>() == 64);
};

/// A ray of sunlight that the water bent.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Photon {
    /// where in the sun's map lies what it lights on the floor
    pub uv: [f32; 2],
    /// how much water it went through
    pub path_m: f32,
    /// of it that entered the water; 0 where there is none
    pub share: f32,
}
const _: () = {
    assert!(offset_of!(Photon, uv) == 0);
    assert!(offset_of!(Photon, path_m) == 8);
    assert!(offset_of!(Photon, share) == 12);
    assert!(size_of::<Photon>() == 16);
};

/// A grid over the sun's map and along its rays, as many cells along each: how much water is nearer the sun.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SunVolumeParams {
    /// along each side
    pub cells: u32,
    /// `float`.
    pub spacing_m: f32,
    /// side of a cell across the rays
    pub cell_m: f32,
    /// `float`.
    pub reserved: f32,
}
const _: () = {
    assert!(offset_of!(SunVolumeParams, cells) == 0);
    assert!(offset_of!(SunVolumeParams, spacing_m) == 4);
    assert!(offset_of!(SunVolumeParams, cell_m) == 8);
    assert!(offset_of!(SunVolumeParams, reserved) == 12);
    assert!(size_of::<SunVolumeParams>() == 16);
};

/// How the water looks: colours in linear light.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct WaterStyle {
    /// Beer-Lambert
    pub absorption_per_m: [f32; 3],
    /// gamma: how far what lies behind is displaced, over the thickness
    pub refraction: f32,
    /// what thick water shows of its own
    pub scatter_color: [f32; 3],
    /// `float`.
    pub scatter_per_m: f32,
    /// of the highlight, GGX
    pub roughness: f32,
    /// of a metal, at normal incidence; water has WATER\_F0
    pub reflectance: [f32; 3],
}
const _: () = {
    assert!(offset_of!(WaterStyle, absorption_per_m) == 0);
    assert!(offset_of!(WaterStyle, refraction) == 12);
    assert!(offset_of!(WaterStyle, scatter_color) == 16);
    assert!(offset_of!(WaterStyle, scatter_per_m) == 28);
    assert!(offset_of!(WaterStyle, roughness) == 32);
    assert!(offset_of!(WaterStyle, reflectance) == 36);
    assert!(size_of::<WaterStyle>() == 48);
};
