// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/sky.hlsl.
//! Kernels of `frame/sky.hlsl`.

use super::{FrameLight, FrameView};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tier, Uniform, bind_draw};

/// The sky, wherever nothing else was drawn (depth still 0, infinitely far).
#[derive(Debug)]
pub struct DrawSky<'a> {
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
}

impl Draw for DrawSky<'_> {
    const STAGE: &'static str = "draw_sky";

    fn vertex(&self) -> &'static Module {
        &DRAW_SKY_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_SKY_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(self.vertex(), self.fragment(), &[("view", Some(self.view.id)), ("light", Some(self.light.id))])
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_SKY_VERTEX, &DRAW_SKY_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_1: &[BindingInfo] =
    &[BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } }];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_sky.deflate"));

static DRAW_SKY_VERTEX: Module = Module {
    name: "DrawSky.vertex",
    entry: "SkyVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 1716 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/sky.hlsl",
    hash: "0e1c8c94444f1467cb486fdacbde0941e3a2b2cd40fe5ca532b4254f6b44da10",
};

static DRAW_SKY_FRAGMENT: Module = Module {
    name: "DrawSky.fragment",
    entry: "SkyFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 1716, bytes: 2024 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/sky.hlsl",
    hash: "a8b3a306052f6cfadb9c032f1c4150947cc5364577e2d438d2ea13a9ebb408a4",
};
