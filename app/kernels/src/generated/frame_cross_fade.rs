// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/cross_fade.hlsl.
//! Kernels of `frame/cross_fade.hlsl`.

use super::CrossFadeParams;
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// One picture over another, as far as its opacity: while the surface goes from one method to the other.
#[derive(Debug)]
pub struct DrawCrossFade<'a> {
    /// `Texture2D<float4> picture`.
    pub picture: Tex<'a>,
    /// `ConstantBuffer<CrossFadeParams> cross_fade`.
    pub cross_fade: Uniform<'a, CrossFadeParams>,
}

impl Draw for DrawCrossFade<'_> {
    const STAGE: &'static str = "draw_cross_fade";

    fn vertex(&self) -> &'static Module {
        &DRAW_CROSS_FADE_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_CROSS_FADE_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[("picture", Some(self.picture.id)), ("cross_fade", Some(self.cross_fade.id))],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_CROSS_FADE_VERTEX, &DRAW_CROSS_FADE_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "picture", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "cross_fade", slot: 1, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_cross_fade.deflate"));

static DRAW_CROSS_FADE_VERTEX: Module = Module {
    name: "DrawCrossFade.vertex",
    entry: "CrossFadeVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 556 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/cross_fade.hlsl",
    hash: "fe283f4ecfa0376694230c9567899a09a275e2222fd30e6a4f487299e4b01a87",
};

static DRAW_CROSS_FADE_FRAGMENT: Module = Module {
    name: "DrawCrossFade.fragment",
    entry: "CrossFadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 556, bytes: 1136 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/cross_fade.hlsl",
    hash: "2d4e805d660a989e5d5448bb54fbb7527288a1d51d2c8e346d1f37feb7ea3d32",
};
