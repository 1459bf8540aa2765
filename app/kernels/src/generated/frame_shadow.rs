// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/shadow.hlsl.
//! Kernels of `frame/shadow.hlsl`.

use super::{FrameLight, FrameStyle, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// The shadow map: each particle as a disc, seen along the sun's rays. Depth only.
#[derive(Debug)]
pub struct DrawShadow<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
}

impl Draw for DrawShadow<'_> {
    const STAGE: &'static str = "draw_shadow";

    fn vertex(&self) -> &'static Module {
        &DRAW_SHADOW_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_SHADOW_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[("positions", Some(self.positions.id)), ("light", Some(self.light.id)), ("style", Some(self.style.id))],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_SHADOW_VERTEX, &DRAW_SHADOW_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_shadow.deflate"));

static DRAW_SHADOW_VERTEX: Module = Module {
    name: "DrawShadow.vertex",
    entry: "ShadowVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3892 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shadow.hlsl",
    hash: "437268db3dd8ad0d69eb99d9d205a2c40709978d338bae9bd15fc46937dafd43",
};

static DRAW_SHADOW_FRAGMENT: Module = Module {
    name: "DrawShadow.fragment",
    entry: "ShadowFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 3892, bytes: 408 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shadow.hlsl",
    hash: "790b8641497b0580bceea15577e8555216a8d2e2025cab725172549c56aee272",
};
