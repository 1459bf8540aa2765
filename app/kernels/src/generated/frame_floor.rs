// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/floor.hlsl.
//! Kernels of `frame/floor.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, ShadowKeyword, SurfaceParams, WaterStyle};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawFloor`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawFloorVariant {
    /// Keyword `POINTS_SHADOW` or `WATER_SHADOW` or `CAUSTICS_SHADOW`.
    pub shadow: ShadowKeyword,
    /// Keyword `SOLIDS_SHADOW`.
    pub solids_shadow: bool,
}

/// The floor under the domain: satin tiles with the soft shadow of fluid and solids, melting into the horizon.
#[derive(Debug)]
pub struct DrawFloor<'a> {
    /// Its variant.
    pub variant: DrawFloorVariant,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `Texture2D<float> solids_shadow_map`.
    pub solids_shadow_map: Option<Tex<'a>>,
    /// `Texture2D<float> shadow_map`.
    pub shadow_map: Option<Tex<'a>>,
    /// `Texture2D<float> sun_thickness`.
    pub sun_thickness: Option<Tex<'a>>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Option<Uniform<'a, SurfaceParams>>,
    /// `ConstantBuffer<WaterStyle> water`.
    pub water: Option<Uniform<'a, WaterStyle>>,
    /// `Texture2D<float> sun_depth`.
    pub sun_depth: Option<Tex<'a>>,
    /// `Texture2D<float4> caustics`.
    pub caustics: Option<Tex<'a>>,
}

impl Draw for DrawFloor<'_> {
    const STAGE: &'static str = "draw_floor";

    fn vertex(&self) -> &'static Module {
        match (self.variant.shadow, self.variant.solids_shadow) {
            (ShadowKeyword::Off, false) => &DRAW_FLOOR_VERTEX,
            (ShadowKeyword::Off, true) => &DRAW_FLOOR_VERTEX,
            (ShadowKeyword::PointsShadow, false) => &DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW,
            (ShadowKeyword::PointsShadow, true) => &DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW,
            (ShadowKeyword::WaterShadow, false) => &DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW,
            (ShadowKeyword::WaterShadow, true) => &DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW,
            (ShadowKeyword::CausticsShadow, false) => &DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW,
            (ShadowKeyword::CausticsShadow, true) => &DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match (self.variant.shadow, self.variant.solids_shadow) {
            (ShadowKeyword::Off, false) => Some(&DRAW_FLOOR_FRAGMENT),
            (ShadowKeyword::Off, true) => Some(&DRAW_FLOOR_FRAGMENT_WITH_SOLIDS_SHADOW),
            (ShadowKeyword::PointsShadow, false) => Some(&DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW),
            (ShadowKeyword::PointsShadow, true) => Some(&DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW_WITH_SOLIDS_SHADOW),
            (ShadowKeyword::WaterShadow, false) => Some(&DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW),
            (ShadowKeyword::WaterShadow, true) => Some(&DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW_WITH_SOLIDS_SHADOW),
            (ShadowKeyword::CausticsShadow, false) => Some(&DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW),
            (ShadowKeyword::CausticsShadow, true) => Some(&DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW_WITH_SOLIDS_SHADOW),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("view", Some(self.view.id)),
                ("style", Some(self.style.id)),
                ("light", Some(self.light.id)),
                ("solids_shadow_map", self.solids_shadow_map.as_ref().map(|bound| bound.id)),
                ("shadow_map", self.shadow_map.as_ref().map(|bound| bound.id)),
                ("sun_thickness", self.sun_thickness.as_ref().map(|bound| bound.id)),
                ("surface", self.surface.as_ref().map(|bound| bound.id)),
                ("water", self.water.as_ref().map(|bound| bound.id)),
                ("sun_depth", self.sun_depth.as_ref().map(|bound| bound.id)),
                ("caustics", self.caustics.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_FLOOR_VERTEX,
    &DRAW_FLOOR_FRAGMENT,
    &DRAW_FLOOR_FRAGMENT_WITH_SOLIDS_SHADOW,
    &DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW_WITH_SOLIDS_SHADOW,
    &DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW_WITH_SOLIDS_SHADOW,
    &DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW_WITH_SOLIDS_SHADOW,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 0, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "solids_shadow_map", slot: 3, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "shadow_map", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "shadow_map", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "solids_shadow_map", slot: 4, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_6: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_7: &[BindingInfo] = &[
    BindingInfo { name: "sun_thickness", slot: 0, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 1, kind: BindingKind::Sampler },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_8: &[BindingInfo] = &[
    BindingInfo { name: "sun_thickness", slot: 0, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 1, kind: BindingKind::Sampler },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "solids_shadow_map", slot: 7, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_9: &[BindingInfo] = &[
    BindingInfo { name: "sun_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "caustics", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 2, kind: BindingKind::Sampler },
    BindingInfo { name: "surface", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_10: &[BindingInfo] = &[
    BindingInfo { name: "sun_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "caustics", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 2, kind: BindingKind::Sampler },
    BindingInfo { name: "surface", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "solids_shadow_map", slot: 7, kind: BindingKind::Texture { filterable: false } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_floor.deflate"));

static DRAW_FLOOR_VERTEX: Module = Module {
    name: "DrawFloor.vertex",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3128 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "3229aa80e8800c7f88f8e832548a7652e483acc5407ba5e450964198ab18106d",
};

static DRAW_FLOOR_FRAGMENT: Module = Module {
    name: "DrawFloor.fragment",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 3128, bytes: 6824 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "25f4978e5de15c8c21fa84231136a9cc5fe9b9f8cf1e9dd4531ed39e37433a66",
};

static DRAW_FLOOR_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 9952, bytes: 16932 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "429ec14fff2dd4dc38a8e3e40ca06df8e4914a01caeab80c34f11de15128a48c",
};

static DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW: Module = Module {
    name: "DrawFloor.vertex+POINTS_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 26884, bytes: 3128 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "993f0347aca4541d2915ce71b72e80bf1e5d0d80829e35370e23f89af117c2a6",
};

static DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+POINTS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 30012, bytes: 16012 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "845b9df8bc932ccdf0d6c6fa49c0a3296524a80810381f14f44fc89ba4d97bc6",
};

static DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+POINTS_SHADOW+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 46024, bytes: 24244 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "3c176a144d7af879139de4ee78032c702f93018934798c7de1130e100585d266",
};

static DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW: Module = Module {
    name: "DrawFloor.vertex+WATER_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 70268, bytes: 3128 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "da1a9186d5902dc4a0eb48a1736296f621f1c821d37b83da0ef750f0525d6191",
};

static DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW: Module = Module {
    name: "DrawFloor.fragment+WATER_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 73396, bytes: 11244 },
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "475bec465a369406175a7f66d7440bde3f89c6c2b617285b831b402a05f26219",
};

static DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+WATER_SHADOW+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 84640, bytes: 20548 },
    bindings: BINDINGS_8,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "15f0e5722dc66959689a33b96020b6566fd36cca548d6fc72506429a4e89c707",
};

static DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW: Module = Module {
    name: "DrawFloor.vertex+CAUSTICS_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 105188, bytes: 3128 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "56d933f63c980945865dfdcb330aeaba8150de53a9feb947e186dbddce9503f6",
};

static DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+CAUSTICS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 108316, bytes: 10372 },
    bindings: BINDINGS_9,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "55a4db78a9e2b8e05c60038db92fe63c5e4be4eb165f7edd364e9a4fd04534ff",
};

static DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+CAUSTICS_SHADOW+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 118688, bytes: 20028 },
    bindings: BINDINGS_10,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "f79d117a47b297a215af02bbb7e5b15fc4ed982ff444b67e7b8bc598f6cc3eb8",
};
