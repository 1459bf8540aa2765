// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/none/layout.hlsli.
//! Host-visible structs of `solver/none/layout.hlsli`.

use std::mem::{offset_of, size_of};

use bytemuck::{Pod, Zeroable};

/// `NoneParams`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct NoneParams {
    /// 0: for ever
    pub lifetime_s: f32,
    /// share of the lifetime by which the shortest lives less
    pub lifetime_variation: f32,
    /// velocity decays as exp(-drag t)
    pub drag_per_s: f32,
    /// share of the speed across a wall that a bounce gives back
    pub restitution: f32,
}
const _: () = {
    assert!(offset_of!(NoneParams, lifetime_s) == 0);
    assert!(offset_of!(NoneParams, lifetime_variation) == 4);
    assert!(offset_of!(NoneParams, drag_per_s) == 8);
    assert!(offset_of!(NoneParams, restitution) == 12);
    assert!(size_of::<NoneParams>() == 16);
};
