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
    hash: "db74c1fb15f178834c624852a0d7b991bcb4ce81958e7f6b30281742c8934367",
};

static DRAW_WATER_FRAGMENT: Module = Module {
    name: "DrawWater.fragment",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 1716, bytes: 15296 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "47e29d5789f17c019dff1ae1e0a34dce5e317cbfe31446706bc6f12deae04307",
};

static DRAW_WATER_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 17012, bytes: 19088 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "b75ce7143daaf9a170f858c56bc218342256098873b2f83436580a97f67dea7e",
};

static DRAW_WATER_VERTEX_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 36100, bytes: 1716 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "bef9d5da7a3e281c7207744a9a00922b54fb95a29fbb4653129c93223e884c01",
};

static DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 37816, bytes: 18112 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "ad3a315c0ba696806bfdba64d26ba4d7725715e0f25fc1ded5237959e58dce95",
};

static DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+SELF_SHADOW+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 55928, bytes: 21632 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "889939dd675b19e9fad29ca9ac53868d0fd1f183c0b58b28af16d947f8df90a3",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 77560, bytes: 1716 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "1be677a5f7db608a1d57607241b6885f35068e2a8d33c2d22ef33297db61304d",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 79276, bytes: 12296 },
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "99ca7c67494fdfaec6086e98570613482511799529f945f177217c7623fdf17a",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 91572, bytes: 16104 },
    bindings: BINDINGS_8,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "0a015407abb6bd975c3f97bbf04279cd3b59a0c54c79f6712dc3e0c40b5761b1",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 107676, bytes: 1716 },
    bindings: BINDINGS_9,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "400abcb32d4d420090b94ef932a9a578d31db6f5e3917ecad4e2ddad1044a3e5",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 109392, bytes: 15112 },
    bindings: BINDINGS_10,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "a6e928db0df971b891172237b1264a7aaa15a0e4d465aff1b6aef7015c2001c4",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SELF_SHADOW+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 124504, bytes: 18648 },
    bindings: BINDINGS_11,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "3da75f0e2e6cbe93f16a9d3b304f0b6ea2303c3d771ea473ae8747721d0285d8",
};
