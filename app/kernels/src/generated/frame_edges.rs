// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/edges.hlsl.
//! Kernels of `frame/edges.hlsl`.

use super::{FrameStyle, FrameView, WaterKeyword};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw};

/// Which variant of [`DrawEdges`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawEdgesVariant {
    /// Keyword `BEHIND_WATER` or `BEFORE_WATER`.
    pub water: WaterKeyword,
}

/// The domain's twelve edges as thin lines, as wide on the screen far as near, smooth at their sides.
/// With water they are drawn twice: what lies behind it before it, to be refracted, and what lies
/// in front over it.
#[derive(Debug)]
pub struct DrawEdges<'a> {
    /// Its variant.
    pub variant: DrawEdgesVariant,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `Texture2D<float> nearness`.
    pub nearness: Option<Tex<'a>>,
}

impl Draw for DrawEdges<'_> {
    const STAGE: &'static str = "draw_edges";

    fn vertex(&self) -> &'static Module {
        match self.variant.water {
            WaterKeyword::Off => &DRAW_EDGES_VERTEX,
            WaterKeyword::BehindWater => &DRAW_EDGES_VERTEX_WITH_BEHIND_WATER,
            WaterKeyword::BeforeWater => &DRAW_EDGES_VERTEX_WITH_BEHIND_WATER,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.water {
            WaterKeyword::Off => Some(&DRAW_EDGES_FRAGMENT),
            WaterKeyword::BehindWater => Some(&DRAW_EDGES_FRAGMENT_WITH_BEHIND_WATER),
            WaterKeyword::BeforeWater => Some(&DRAW_EDGES_FRAGMENT_WITH_BEFORE_WATER),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("view", Some(self.view.id)),
                ("style", Some(self.style.id)),
                ("nearness", self.nearness.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_EDGES_VERTEX,
    &DRAW_EDGES_FRAGMENT,
    &DRAW_EDGES_VERTEX_WITH_BEHIND_WATER,
    &DRAW_EDGES_FRAGMENT_WITH_BEHIND_WATER,
    &DRAW_EDGES_FRAGMENT_WITH_BEFORE_WATER,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "nearness", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
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
    hash: "cef1708aa8fe8ce85ed39939d849310c92592c5db1c80f341294b51331b33db8",
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
    hash: "99c3d7a8ec0491854e9d2d376547d1613354039186ddec6982b845ba3f1ee1c7",
};

static DRAW_EDGES_VERTEX_WITH_BEHIND_WATER: Module = Module {
    name: "DrawEdges.vertex+BEHIND_WATER",
    entry: "EdgesVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_edges.vertex+behind_water.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "4a77ecfff965b04ac3ab9e7d27df21037b099a3fb2ebb89a9e9c0cf8990aa287",
};

static DRAW_EDGES_FRAGMENT_WITH_BEHIND_WATER: Module = Module {
    name: "DrawEdges.fragment+BEHIND_WATER",
    entry: "EdgesFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_edges.fragment+behind_water.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "39d1e4130c410aaf5270e15501a1351586e9e9165241f5840c41df79814cf73c",
};

static DRAW_EDGES_FRAGMENT_WITH_BEFORE_WATER: Module = Module {
    name: "DrawEdges.fragment+BEFORE_WATER",
    entry: "EdgesFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_edges.fragment+before_water.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "b58df42b1d2baa0925b5bbc92dbe60b0ea44f4f537cd8c17e7af3ab31218a31b",
};
