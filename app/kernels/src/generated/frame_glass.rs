// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/glass.hlsl.
//! Kernels of `frame/glass.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, SolidPaint, SolidPose, SolidVertex, WaterKeyword};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawGlass`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawGlassVariant {
    /// Keyword `BEHIND_WATER` or `BEFORE_WATER`.
    pub water: WaterKeyword,
}

/// Solids of glass: a film that mirrors more the flatter it is looked along, a little darker there and at rims. It is drawn
/// in halves: its far faces, then its near ones; with water what lies behind it before it, to be refracted, and what lies
/// in front over it.
#[derive(Debug)]
pub struct DrawGlass<'a> {
    /// Its variant.
    pub variant: DrawGlassVariant,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `StructuredBuffer<uint> solid_indices`.
    pub solid_indices: Buf<'a, u32>,
    /// `StructuredBuffer<SolidVertex> solid_vertices`.
    pub solid_vertices: Buf<'a, SolidVertex>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `StructuredBuffer<SolidPaint> solid_paints`.
    pub solid_paints: Buf<'a, SolidPaint>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Option<Tex<'a>>,
}

impl Draw for DrawGlass<'_> {
    const STAGE: &'static str = "draw_glass";

    fn vertex(&self) -> &'static Module {
        match self.variant.water {
            WaterKeyword::Off => &DRAW_GLASS_VERTEX,
            WaterKeyword::BehindWater => &DRAW_GLASS_VERTEX_WITH_BEHIND_WATER,
            WaterKeyword::BeforeWater => &DRAW_GLASS_VERTEX_WITH_BEHIND_WATER,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.water {
            WaterKeyword::Off => Some(&DRAW_GLASS_FRAGMENT),
            WaterKeyword::BehindWater => Some(&DRAW_GLASS_FRAGMENT_WITH_BEHIND_WATER),
            WaterKeyword::BeforeWater => Some(&DRAW_GLASS_FRAGMENT_WITH_BEFORE_WATER),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("view", Some(self.view.id)),
                ("solid_indices", Some(self.solid_indices.id)),
                ("solid_vertices", Some(self.solid_vertices.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("solid_paints", Some(self.solid_paints.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
                ("inverse_depth", self.inverse_depth.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_GLASS_VERTEX,
    &DRAW_GLASS_FRAGMENT,
    &DRAW_GLASS_VERTEX_WITH_BEHIND_WATER,
    &DRAW_GLASS_FRAGMENT_WITH_BEHIND_WATER,
    &DRAW_GLASS_FRAGMENT_WITH_BEFORE_WATER,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo {
        name: "solid_indices",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "solid_vertices",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "solid_poses", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "solid_paints",
        slot: 6,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo {
        name: "solid_indices",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "solid_vertices",
        slot: 5,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "solid_poses", slot: 6, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "solid_paints",
        slot: 7,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "inverse_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_glass.deflate"));

static DRAW_GLASS_VERTEX: Module = Module {
    name: "DrawGlass.vertex",
    entry: "GlassVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4456 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/glass.hlsl",
    hash: "e2a76ae2bac75034be8a2c3cbdf850ad37364190c56561190e77f7ff1d47514f",
};

static DRAW_GLASS_FRAGMENT: Module = Module {
    name: "DrawGlass.fragment",
    entry: "GlassFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4456, bytes: 6600 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/glass.hlsl",
    hash: "0b247c2e283e7fdc1aea00353cd31d782d2ffe39026e1038048f4be612dedec6",
};

static DRAW_GLASS_VERTEX_WITH_BEHIND_WATER: Module = Module {
    name: "DrawGlass.vertex+BEHIND_WATER",
    entry: "GlassVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 11056, bytes: 4456 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/glass.hlsl",
    hash: "17312c553e2e223deceb821e4cfb17ee192a2c92322fc634ecfcdadc22dd62b7",
};

static DRAW_GLASS_FRAGMENT_WITH_BEHIND_WATER: Module = Module {
    name: "DrawGlass.fragment+BEHIND_WATER",
    entry: "GlassFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 15512, bytes: 7352 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/glass.hlsl",
    hash: "5c9226895b6e68a8165937e027beca84021d11d51d83224ead1dd5c3bb5bce86",
};

static DRAW_GLASS_FRAGMENT_WITH_BEFORE_WATER: Module = Module {
    name: "DrawGlass.fragment+BEFORE_WATER",
    entry: "GlassFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 22864, bytes: 7368 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/glass.hlsl",
    hash: "8900e04877376c8d905b0b6884991629e734b505f7416916f4e0b029921e9cde",
};
