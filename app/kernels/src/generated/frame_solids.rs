// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/solids.hlsl.
//! Kernels of `frame/solids.hlsl`.

use super::{
    FrameLight, FrameStyle, FrameView, SolidPaint, SolidPose, SolidVertex, SunKeyword, SunVolumeParams, WaterStyle,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawSolids`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawSolidsVariant {
    /// Keyword `POINTS_SUN` or `VOLUME_SUN`.
    pub sun: SunKeyword,
}

/// The opaque solids: smooth paint in the light of sun and sky, shaded by each other and by the fluid.
#[derive(Debug)]
pub struct DrawSolids<'a> {
    /// Its variant.
    pub variant: DrawSolidsVariant,
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
    /// `Texture2D<float> solids_shadow_map`.
    pub solids_shadow_map: Tex<'a>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `Texture2D<float> shadow_map`.
    pub shadow_map: Option<Tex<'a>>,
    /// `StructuredBuffer<float> sun_volume`.
    pub sun_volume: Option<Buf<'a, f32>>,
    /// `ConstantBuffer<SunVolumeParams> volume`.
    pub volume: Option<Uniform<'a, SunVolumeParams>>,
    /// `ConstantBuffer<WaterStyle> water`.
    pub water: Option<Uniform<'a, WaterStyle>>,
}

impl Draw for DrawSolids<'_> {
    const STAGE: &'static str = "draw_solids";

    fn vertex(&self) -> &'static Module {
        match self.variant.sun {
            SunKeyword::Off => &DRAW_SOLIDS_VERTEX,
            SunKeyword::PointsSun => &DRAW_SOLIDS_VERTEX_WITH_POINTS_SUN,
            SunKeyword::VolumeSun => &DRAW_SOLIDS_VERTEX_WITH_VOLUME_SUN,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.sun {
            SunKeyword::Off => Some(&DRAW_SOLIDS_FRAGMENT),
            SunKeyword::PointsSun => Some(&DRAW_SOLIDS_FRAGMENT_WITH_POINTS_SUN),
            SunKeyword::VolumeSun => Some(&DRAW_SOLIDS_FRAGMENT_WITH_VOLUME_SUN),
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
                ("solids_shadow_map", Some(self.solids_shadow_map.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
                ("shadow_map", self.shadow_map.as_ref().map(|bound| bound.id)),
                ("sun_volume", self.sun_volume.as_ref().map(|bound| bound.id)),
                ("volume", self.volume.as_ref().map(|bound| bound.id)),
                ("water", self.water.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_SOLIDS_VERTEX,
    &DRAW_SOLIDS_FRAGMENT,
    &DRAW_SOLIDS_VERTEX_WITH_POINTS_SUN,
    &DRAW_SOLIDS_FRAGMENT_WITH_POINTS_SUN,
    &DRAW_SOLIDS_VERTEX_WITH_VOLUME_SUN,
    &DRAW_SOLIDS_FRAGMENT_WITH_VOLUME_SUN,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
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

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "solids_shadow_map", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo {
        name: "solid_indices",
        slot: 5,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "solid_vertices",
        slot: 6,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "solid_poses", slot: 7, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "solid_paints",
        slot: 8,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "solids_shadow_map", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "shadow_map", slot: 4, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo {
        name: "solid_indices",
        slot: 7,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "solid_vertices",
        slot: 8,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "solid_poses", slot: 9, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "solid_paints",
        slot: 10,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "solids_shadow_map", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sun_volume", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "water", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_solids.deflate"));

static DRAW_SOLIDS_VERTEX: Module = Module {
    name: "DrawSolids.vertex",
    entry: "SolidsVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4612 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids.hlsl",
    hash: "7f73f36413b7b396ba20199a31f02c340c21c729052e5600ae41917622c78945",
};

static DRAW_SOLIDS_FRAGMENT: Module = Module {
    name: "DrawSolids.fragment",
    entry: "SolidsFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4612, bytes: 9892 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids.hlsl",
    hash: "1b3586b589ea5e785f5b090a2995a4fd9be79e6b9448dd940c0954b8ddc3143b",
};

static DRAW_SOLIDS_VERTEX_WITH_POINTS_SUN: Module = Module {
    name: "DrawSolids.vertex+POINTS_SUN",
    entry: "SolidsVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 14504, bytes: 4612 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids.hlsl",
    hash: "662900df8fdaedcdcf0fd7b08c6368de7ff293710ac496e3f4ffb3c2d5ee135f",
};

static DRAW_SOLIDS_FRAGMENT_WITH_POINTS_SUN: Module = Module {
    name: "DrawSolids.fragment+POINTS_SUN",
    entry: "SolidsFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 19116, bytes: 13572 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids.hlsl",
    hash: "bab8abafd451cb26cdea1a5382a1ea07acb7b51873a1ecc5f2acc570a8ce2fe6",
};

static DRAW_SOLIDS_VERTEX_WITH_VOLUME_SUN: Module = Module {
    name: "DrawSolids.vertex+VOLUME_SUN",
    entry: "SolidsVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 32688, bytes: 4612 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids.hlsl",
    hash: "a217aa4c209b803ba9f51b5c8626a71dcbe6da2cc7618bbb0a4209d8f5c81132",
};

static DRAW_SOLIDS_FRAGMENT_WITH_VOLUME_SUN: Module = Module {
    name: "DrawSolids.fragment+VOLUME_SUN",
    entry: "SolidsFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 37300, bytes: 12880 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids.hlsl",
    hash: "1a8d2524b6376d68df16af28e4c81e4a8ff3f46be5c884fd0012495ee968136b",
};
