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
    hash: "e0b4e608af3e511ae3b4648264c48ae2c6c46c1e74169091daadad3470e291a7",
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
    hash: "cbbb25a4e71425733d43a1dd49f987bec4d0163131f99a97519f4fef2ab0d12d",
};
