// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/layout.hlsli.
//! Host-visible structs of `frame/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// The camera: where it stands, its axes, and how wide it sees. Depth is reversed with the far
/// plane at infinity: depth = near\_m / distance along `forward`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct FrameView {
    /// `float3`.
    pub eye_m: [f32; 3],
    /// `float`.
    pub near_m: f32,
    /// `float3`.
    pub right: [f32; 3],
    /// `float`.
    pub tan_half_width: f32,
    /// `float3`.
    pub up: [f32; 3],
    /// `float`.
    pub tan_half_height: f32,
    /// `float3`.
    pub forward: [f32; 3],
    /// how far apart two drawn pixels are at distance 1
    pub pixel_angle: f32,
    /// of the drawn (supersampled) picture
    pub size_px: [f32; 2],
    /// drawn pixels a side of one picture pixel
    pub supersample: f32,
    /// `float`.
    pub reserved: f32,
}
const _: () = {
    assert!(offset_of!(FrameView, eye_m) == 0);
    assert!(offset_of!(FrameView, near_m) == 12);
    assert!(offset_of!(FrameView, right) == 16);
    assert!(offset_of!(FrameView, tan_half_width) == 28);
    assert!(offset_of!(FrameView, up) == 32);
    assert!(offset_of!(FrameView, tan_half_height) == 44);
    assert!(offset_of!(FrameView, forward) == 48);
    assert!(offset_of!(FrameView, pixel_angle) == 60);
    assert!(offset_of!(FrameView, size_px) == 64);
    assert!(offset_of!(FrameView, supersample) == 72);
    assert!(offset_of!(FrameView, reserved) == 76);
    assert!(size_of::<FrameView>() == 80);
};

/// The sun and its shadow map: a parallel projection along the sun's rays.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct FrameLight {
    /// `float3`.
    pub to_sun: [f32; 3],
    /// metres along the rays over which shadow depth goes from 1 to 0
    pub shadow_range_m: f32,
    /// `float3`.
    pub sun_color: [f32; 3],
    /// side of the shadow map
    pub shadow_texels: f32,
    /// dot(xyz, p) + w: column in 0..1
    pub shadow_u: [f32; 4],
    /// row in 0..1
    pub shadow_v: [f32; 4],
    /// 1 nearest the sun, 0 farthest
    pub shadow_depth: [f32; 4],
    /// `float3`.
    pub sky_zenith: [f32; 3],
    /// `float`.
    pub shadow_texel_m: f32,
    /// `float3`.
    pub sky_horizon: [f32; 3],
    /// `float`.
    pub exposure: f32,
}
const _: () = {
    assert!(offset_of!(FrameLight, to_sun) == 0);
    assert!(offset_of!(FrameLight, shadow_range_m) == 12);
    assert!(offset_of!(FrameLight, sun_color) == 16);
    assert!(offset_of!(FrameLight, shadow_texels) == 28);
    assert!(offset_of!(FrameLight, shadow_u) == 32);
    assert!(offset_of!(FrameLight, shadow_v) == 48);
    assert!(offset_of!(FrameLight, shadow_depth) == 64);
    assert!(offset_of!(FrameLight, sky_zenith) == 80);
    assert!(offset_of!(FrameLight, shadow_texel_m) == 92);
    assert!(offset_of!(FrameLight, sky_horizon) == 96);
    assert!(offset_of!(FrameLight, exposure) == 108);
    assert!(size_of::<FrameLight>() == 112);
};

/// What is drawn and how it looks.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct FrameStyle {
    /// `float3`.
    pub domain_size_m: [f32; 3],
    /// side of a floor tile
    pub tile_m: f32,
    /// `float3`.
    pub floor_color: [f32; 3],
    /// distance over which the floor melts into the horizon
    pub floor_fade_m: f32,
    /// of a drawn particle
    pub radius_m: f32,
    /// 1 / the speed that is drawn as foam
    pub inverse_speed_scale_s_m: f32,
    /// how deep the sun reaches into the fluid
    pub light_depth_m: f32,
    /// of the domain's lines, in picture pixels
    pub edge_width_px: f32,
    /// `float3`.
    pub edge_color: [f32; 3],
    /// `float`.
    pub edge_opacity: f32,
    /// reach of the ambient occlusion
    pub occlusion_m: f32,
    /// `float`.
    pub occlusion_strength: f32,
    /// `float2`.
    pub reserved: [f32; 2],
}
const _: () = {
    assert!(offset_of!(FrameStyle, domain_size_m) == 0);
    assert!(offset_of!(FrameStyle, tile_m) == 12);
    assert!(offset_of!(FrameStyle, floor_color) == 16);
    assert!(offset_of!(FrameStyle, floor_fade_m) == 28);
    assert!(offset_of!(FrameStyle, radius_m) == 32);
    assert!(offset_of!(FrameStyle, inverse_speed_scale_s_m) == 36);
    assert!(offset_of!(FrameStyle, light_depth_m) == 40);
    assert!(offset_of!(FrameStyle, edge_width_px) == 44);
    assert!(offset_of!(FrameStyle, edge_color) == 48);
    assert!(offset_of!(FrameStyle, edge_opacity) == 60);
    assert!(offset_of!(FrameStyle, occlusion_m) == 64);
    assert!(offset_of!(FrameStyle, occlusion_strength) == 68);
    assert!(offset_of!(FrameStyle, reserved) == 72);
    assert!(size_of::<FrameStyle>() == 80);
};

/// How much of one picture shows over another.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct CrossFadeParams {
    /// `float`.
    pub opacity: f32,
    /// `float3`.
    pub reserved: [f32; 3],
}
const _: () = {
    assert!(offset_of!(CrossFadeParams, opacity) == 0);
    assert!(offset_of!(CrossFadeParams, reserved) == 4);
    assert!(size_of::<CrossFadeParams>() == 16);
};

/// A corner of a solid's triangles, in the solid's own frame.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SolidVertex {
    /// `float3`.
    pub position_m: [f32; 3],
    /// of the scene's
    pub solid: u32,
    /// out of what is solid, into a cavity
    pub normal: [f32; 3],
    /// 1 where a hollow one's wall ends, which shows its thickness; of ground its share of the
    pub rim: f32,
}
const _: () = {
    assert!(offset_of!(SolidVertex, position_m) == 0);
    assert!(offset_of!(SolidVertex, solid) == 12);
    assert!(offset_of!(SolidVertex, normal) == 16);
    assert!(offset_of!(SolidVertex, rim) == 28);
    assert!(size_of::<SolidVertex>() == 32);
};

/// What a solid looks like.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SolidPaint {
    /// of its surface, in linear light
    pub color: [f32; 3],
    /// share of what smooth paint mirrors
    pub gloss: f32,
    /// the same where `rim` is 1
    pub other: [f32; 3],
    /// `float`.
    pub reserved: f32,
}
const _: () = {
    assert!(offset_of!(SolidPaint, color) == 0);
    assert!(offset_of!(SolidPaint, gloss) == 12);
    assert!(offset_of!(SolidPaint, other) == 16);
    assert!(offset_of!(SolidPaint, reserved) == 28);
    assert!(size_of::<SolidPaint>() == 32);
};
