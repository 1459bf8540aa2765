// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/water.hlsl.
//! Kernels of `surface/water.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, SunVolumeParams, SurfaceParams, WaterStyle};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawWater`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawWaterVariant {
    /// Keyword `MESH_NORMALS`.
    pub mesh_normals: bool,
    /// Keyword `SELF_SHADOW`.
    pub self_shadow: bool,
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
        match (self.variant.mesh_normals, self.variant.self_shadow) {
            (false, false) => &DRAW_WATER_VERTEX,
            (false, true) => &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
            (true, false) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
            (true, true) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match (self.variant.mesh_normals, self.variant.self_shadow) {
            (false, false) => Some(&DRAW_WATER_FRAGMENT),
            (false, true) => Some(&DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW),
            (true, false) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS),
            (true, true) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW),
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
    &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW,
    &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS,
    &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
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

static BINDINGS_2: &[BindingInfo] = &[BindingInfo { name: "view", slot: 7, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_3: &[BindingInfo] = &[
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

static BINDINGS_4: &[BindingInfo] = &[BindingInfo { name: "view", slot: 6, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_5: &[BindingInfo] = &[
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

static BINDINGS_6: &[BindingInfo] = &[BindingInfo { name: "view", slot: 8, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_7: &[BindingInfo] = &[
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

static DRAW_WATER_VERTEX: Module = Module {
    name: "DrawWater.vertex",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_water.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "03b5f15f24a637dc1f603760fc58a514dbb3bde39ff4a7fa67c896081977e532",
};

static DRAW_WATER_FRAGMENT: Module = Module {
    name: "DrawWater.fragment",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_water.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "3f1e6cb80836aba8ab3f1764941ead936514042902fb77973bbba77a9982bf1b",
};

static DRAW_WATER_VERTEX_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_water.vertex+self_shadow.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "b4fb6fc63cfd6c15d74231b36fabfd53fb90e58651fd9e176d9a0bebadd2e6b9",
};

static DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_water.fragment+self_shadow.spv"),
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "557c06a5e42e27f7c3c95ebac59b9e0b1b5f4d1fb522ddc1939363a473f5c463",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_water.vertex+mesh_normals.spv"),
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "1ced64f428ea0ff41eb83d7fd595f2a0f77c7bc0b34d3c00dd96061eb6293f2a",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_water.fragment+mesh_normals.spv"),
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "92647db8143992e38b493caf35bdd4cfee2de49172025c6b169ac6299a9231be",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_water.vertex+mesh_normals+self_shadow.spv"),
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "dfd11daa6c9c2e71835ea9e86f8a2ad80bb1b652d5c9d27ae93f092c893e6e41",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_water.fragment+mesh_normals+self_shadow.spv"),
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "93ce753dc084659b001cef6d667970a01503815b86704f5230db13155a89ed03",
};
