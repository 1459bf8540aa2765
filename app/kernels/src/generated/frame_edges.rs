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
    hash: "1d374f5b29cd9c42b47c96b9f307165c3a9a6c4802661fd63ecfafceb1890536",
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
    hash: "3c7ff2cfdca89b272591dce518a1985a849db6d25bc39c776058a512149b91b4",
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
    hash: "450514da4266a3c92d0967d82316727d7f7e72c99334dd41c60e28d290db30e1",
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
    hash: "fdb28e154a685690fb214433a9b6d44b5e64b93547b5b78354a26e2ef631cecb",
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
    hash: "a54b05a8201aadc2810cc50409917c29429807e055fd79c4e30af54ee889d27d",
};
