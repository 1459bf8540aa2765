// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/layout.hlsl.
//! Host-visible structs of `surface/layout.hlsl`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// A fluid's surface in screen space.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SurfaceParams {
    /// the fluid is cut off outside this box: at a tank's glass
    pub box_min_m: [f32; 3],
    /// of a particle's sphere
    pub radius_m: f32,
    /// `float3`.
    pub box_max_m: [f32; 3],
    /// radius of the disc on which a particle's volume counts as thickness
    pub spread_m: f32,
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
    /// `float2`.
    pub reserved: [f32; 2],
}
const _: () = {
    assert!(offset_of!(SurfaceParams, box_min_m) == 0);
    assert!(offset_of!(SurfaceParams, radius_m) == 12);
    assert!(offset_of!(SurfaceParams, box_max_m) == 16);
    assert!(offset_of!(SurfaceParams, spread_m) == 28);
    assert!(offset_of!(SurfaceParams, spacing_m) == 32);
    assert!(offset_of!(SurfaceParams, smoothing_m) == 36);
    assert!(offset_of!(SurfaceParams, most_reach_px) == 40);
    assert!(offset_of!(SurfaceParams, range_m) == 44);
    assert!(offset_of!(SurfaceParams, clamp_m) == 48);
    assert!(offset_of!(SurfaceParams, flow_m2) == 52);
    assert!(offset_of!(SurfaceParams, reserved) == 56);
    assert!(size_of::<SurfaceParams>() == 64);
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
    /// share of the floor's brightness that the caustics move
    pub ripple: f32,
    /// side of the caustics' map
    pub caustic_texels: f32,
    /// the map reaches so far beyond the domain
    pub caustic_margin_m: f32,
}
const _: () = {
    assert!(offset_of!(WaterStyle, absorption_per_m) == 0);
    assert!(offset_of!(WaterStyle, refraction) == 12);
    assert!(offset_of!(WaterStyle, scatter_color) == 16);
    assert!(offset_of!(WaterStyle, scatter_per_m) == 28);
    assert!(offset_of!(WaterStyle, roughness) == 32);
    assert!(offset_of!(WaterStyle, ripple) == 36);
    assert!(offset_of!(WaterStyle, caustic_texels) == 40);
    assert!(offset_of!(WaterStyle, caustic_margin_m) == 44);
    assert!(size_of::<WaterStyle>() == 48);
};
