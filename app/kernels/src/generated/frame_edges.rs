// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/edges.hlsl.
//! Kernels of `frame/edges.hlsl`.

use super::{FrameStyle, FrameView, WaterKeyword};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

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
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Option<Tex<'a>>,
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
                ("inverse_depth", self.inverse_depth.as_ref().map(|bound| bound.id)),
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
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_edges.deflate"));

static DRAW_EDGES_VERTEX: Module = Module {
    name: "DrawEdges.vertex",
    entry: "EdgesVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5424 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "7c560ab509a6efa7efaddad9821ba3b7eebefc11347a88107afb75de4918fa0a",
};

static DRAW_EDGES_FRAGMENT: Module = Module {
    name: "DrawEdges.fragment",
    entry: "EdgesFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 5424, bytes: 2480 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "3def19f1824ebb1d599a6b9da034faaf8df349a377e0c26347a9e52517c8fe41",
};

static DRAW_EDGES_VERTEX_WITH_BEHIND_WATER: Module = Module {
    name: "DrawEdges.vertex+BEHIND_WATER",
    entry: "EdgesVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 7904, bytes: 5424 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "0bb9129a1e3c6af056f9aa63be2c628da35636ac16fc50829d8a434ec31e00e4",
};

static DRAW_EDGES_FRAGMENT_WITH_BEHIND_WATER: Module = Module {
    name: "DrawEdges.fragment+BEHIND_WATER",
    entry: "EdgesFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 13328, bytes: 3176 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "f9f257dc392422b08e6c53ec05dd50a664b0ad72c706fc0b62c68b773866c056",
};

static DRAW_EDGES_FRAGMENT_WITH_BEFORE_WATER: Module = Module {
    name: "DrawEdges.fragment+BEFORE_WATER",
    entry: "EdgesFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 16504, bytes: 3192 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/edges.hlsl",
    hash: "ac0630e07dd0fb96f57b0460dccf25967ee4ae58430a7594ee4678abf44b1a8c",
};
