// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/edges.hlsl.
//! Kernels of `frame/edges.hlsl`.

use super::{FrameStyle, FrameView};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, StageKind, Tier, Uniform, bind_draw};

/// The domain's twelve edges as thin lines, as wide on the screen far as near, smooth at their sides.
#[derive(Debug)]
pub struct DrawEdges<'a> {
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
}

impl Draw for DrawEdges<'_> {
    const STAGE: &'static str = "draw_edges";

    fn vertex(&self) -> &'static Module {
        &DRAW_EDGES_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_EDGES_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(self.vertex(), self.fragment(), &[("view", Some(self.view.id)), ("style", Some(self.style.id))])
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_EDGES_VERTEX, &DRAW_EDGES_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
];

static DRAW_EDGES_VERTEX: Module = Module {
    name: "DrawEdges.vertex",
    entry: "EdgesVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_edges.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "2f13ff8aefb0e22cb8ff7a7dae3364ebf8f53675f40576e934d3f15249dcf086",
};

static DRAW_EDGES_FRAGMENT: Module = Module {
    name: "DrawEdges.fragment",
    entry: "EdgesFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_edges.fragment.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "3e2958ab9d2274aa94d2d7bd95f467de403204d2f8cc5ddba03997a8e8e310e6",
};
