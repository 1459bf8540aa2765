// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/water.hlsl.
//! Kernels of `surface/water.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, SunVolumeParams, SurfaceParams, WaterStyle};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawWater`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawWaterVariant {
    /// Keyword `MESH_NORMALS`.
    pub mesh_normals: bool,
    /// Keyword `SELF_SHADOW`.
    pub self_shadow: bool,
    /// Keyword `SOLIDS_SHADOW`.
    pub solids_shadow: bool,
}

/// The water as it is seen: every pixel that the smoothed surface covers, shaded once, over the scene
/// behind it. Alpha is 1 there. What is opaque and in front stays in front.
#[derive(Debug)]
pub struct DrawWater<'a> {
    /// Its variant.
    pub variant: DrawWaterVariant,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `Texture2D<float> thickness`.
    pub thickness: Tex<'a>,
    /// `Texture2D<float4> scene`.
    pub scene: Tex<'a>,
    /// `Texture2D<float> scene_depth`.
    pub scene_depth: Tex<'a>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
    /// `ConstantBuffer<WaterStyle> water`.
    pub water: Uniform<'a, WaterStyle>,
    /// `Texture2D<float> solids_shadow_map`.
    pub solids_shadow_map: Option<Tex<'a>>,
    /// `StructuredBuffer<float> sun_volume`.
    pub sun_volume: Option<Buf<'a, f32>>,
    /// `ConstantBuffer<SunVolumeParams> volume`.
    pub volume: Option<Uniform<'a, SunVolumeParams>>,
    /// `Texture2D<float4> mesh_normals`.
    pub mesh_normals: Option<Tex<'a>>,
}

impl Draw for DrawWater<'_> {
    const STAGE: &'static str = "draw_water";

    fn vertex(&self) -> &'static Module {
        match (self.variant.mesh_normals, self.variant.self_shadow, self.variant.solids_shadow) {
            (false, false, false) => &DRAW_WATER_VERTEX,
            (false, false, true) => &DRAW_WATER_VERTEX,
            (false, true, false) => &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
            (false, true, true) => &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
            (true, false, false) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
            (true, false, true) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
            (true, true, false) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
            (true, true, true) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match (self.variant.mesh_normals, self.variant.self_shadow, self.variant.solids_shadow) {
            (false, false, false) => Some(&DRAW_WATER_FRAGMENT),
            (false, false, true) => Some(&DRAW_WATER_FRAGMENT_WITH_SOLIDS_SHADOW),
            (false, true, false) => Some(&DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW),
            (false, true, true) => Some(&DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW),
            (true, false, false) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS),
            (true, false, true) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW),
            (true, true, false) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW),
            (true, true, true) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("view", Some(self.view.id)),
                ("inverse_depth", Some(self.inverse_depth.id)),
                ("thickness", Some(self.thickness.id)),
                ("scene", Some(self.scene.id)),
                ("scene_depth", Some(self.scene_depth.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
                ("surface", Some(self.surface.id)),
                ("water", Some(self.water.id)),
                ("solids_shadow_map", self.solids_shadow_map.as_ref().map(|bound| bound.id)),
                ("sun_volume", self.sun_volume.as_ref().map(|bound| bound.id)),
                ("volume", self.volume.as_ref().map(|bound| bound.id)),
                ("mesh_normals", self.mesh_normals.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_WATER_VERTEX,
    &DRAW_WATER_FRAGMENT,
    &DRAW_WATER_FRAGMENT_WITH_SOLIDS_SHADOW,
    &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW,
    &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW,
    &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW,
];

static BINDINGS_0: &[BindingInfo] = &[BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 4, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 4, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 10, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_3: &[BindingInfo] = &[BindingInfo { name: "view", slot: 7, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 6, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 8, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 9, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 10, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 6, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 8, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 9, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 10, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 12, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_6: &[BindingInfo] = &[BindingInfo { name: "view", slot: 6, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_7: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 5, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 7, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 9, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_8: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 5, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 7, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 9, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 11, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_9: &[BindingInfo] = &[BindingInfo { name: "view", slot: 8, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_10: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 7, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 9, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 11, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_11: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 7, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 9, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 11, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 13, kind: BindingKind::Texture { filterable: false } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_water.deflate"));

static DRAW_WATER_VERTEX: Module = Module {
    name: "DrawWater.vertex",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 1716 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "275d099d29284905adddcd2cd221e8b04fa6cffe784b151e45a4d019cbdcb834",
};

static DRAW_WATER_FRAGMENT: Module = Module {
    name: "DrawWater.fragment",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 1716, bytes: 15224 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "0d1f326e78da31a6dc9f0e4ad5d1de4083aa5ba99f6036e1c926cd4483f1e960",
};

static DRAW_WATER_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 16940, bytes: 19016 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "6d0e1bb858a1fc6a559367d967ae749161d42118a54ff75c49e48f5451a1e9ae",
};

static DRAW_WATER_VERTEX_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 35956, bytes: 1716 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "ac119127b8dea1955315f1c9aee4e487d57e683047773bc7ce45a6beb8c84627",
};

static DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 37672, bytes: 18040 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "1ecb545583e630542c475adc17348b7ad624351caa663d448a525234cc3ccdde",
};

static DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+SELF_SHADOW+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 55712, bytes: 21560 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "5197176f3fbb699bc7fbe1f49531797a0054e1f870361344b8a587e62d57cc0e",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 77272, bytes: 1716 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "23ab33ef17e0f041925bc00a5830ea1c20b424679df02acba80b6df1956bc557",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 78988, bytes: 12224 },
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "fe19ffa88ef1380338d9e739402c52d00a7aa38e839f5d569e97ce7a2d5a5cc9",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 91212, bytes: 16032 },
    bindings: BINDINGS_8,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "4da2b8345962403e54f9c7404182f8c5a9eaf506e4f37410dce3c3df13db55c0",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 107244, bytes: 1716 },
    bindings: BINDINGS_9,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "e22ea2c595befeb0c62d3209b759db9493d5c4aa8f06900b82407df65b7b4f94",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 108960, bytes: 15040 },
    bindings: BINDINGS_10,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "7708da362692afd4a6e9b10d8ba8a20142d7ec704a0746b74c5d749e89cbd628",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SELF_SHADOW+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 124000, bytes: 18576 },
    bindings: BINDINGS_11,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "e6e0d2f8273fb6eb24562b76e0c19ec06987c9d09339f34c62573686b39c4d3d",
};
