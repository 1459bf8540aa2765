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
    hash: "7038f7d35d9ea172d70ec6b17150043f3bceda660309c89dace8cdd4a134c0a5",
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
    hash: "3dba5d50bcaa63b1eaecb66e29bd6b5fc02c372fbf6622cebb809d9f73141a48",
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
    hash: "58f8c7a9fc85fdc6575b0ea14a4cacadedc84958199999a7b600c1f8a171f58a",
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
    hash: "a69408eca73195ae02d5cccad3360b944132b809468ed8d307122da071459ae3",
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
    hash: "9c96894b5e068f6fd0ae2f84478906487cac483cfc8d5f16a4b417034cbd2cdc",
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
    hash: "c0e5805d156767a2f3d28c1d1f27d1bc2459e8a4ee3091e30feee68fcb4b8ee1",
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
    hash: "0bfeed7380f1e88e7999367e0dcb2ff4ad36d2409bf3ff05185a39c36e3892a4",
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
    hash: "4ed60467b492c4afebb9cf22c3ed284b7b21e04d58c1f09da571633427dfc9a0",
};
