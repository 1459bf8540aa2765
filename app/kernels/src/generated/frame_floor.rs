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
    hash: "f414bf5bf2b119a6cd7f80242d2060c8fb360d996a95e01517387ea8611dd7c3",
};

static DRAW_FLOOR_FRAGMENT: Module = Module {
    name: "DrawFloor.fragment",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 3128, bytes: 6772 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "fbfc1f61ef99e93474d59525b7380c668b66d902e3d92f675b1e79bfde3188de",
};

static DRAW_FLOOR_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 9900, bytes: 16896 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "e8658c7817e2bbf48d1d9a7b2bce5b512760c8a3545a9c98676def226c08e2af",
};

static DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW: Module = Module {
    name: "DrawFloor.vertex+POINTS_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 26796, bytes: 3128 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "4fe51d7c3c1a199f562de9138b51b964529eaa950d26fc4f85b02d6e46c0b73a",
};

static DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+POINTS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 29924, bytes: 15976 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "7707a23d6479f337554cf96ba7e4686a00c55516c3860e7df19f3ab0394441c0",
};

static DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+POINTS_SHADOW+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 45900, bytes: 24208 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "23a406059f9eb5b796939b7ecb81f544bfd87ecb19aa5500585478f21a075507",
};

static DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW: Module = Module {
    name: "DrawFloor.vertex+WATER_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 70108, bytes: 3128 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "c73773444356212e653673487863d2903fd596da48a0be51d453d578b9a1331e",
};

static DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW: Module = Module {
    name: "DrawFloor.fragment+WATER_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 73236, bytes: 11288 },
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "e882af5bb864992654d338a476495e1b75da8861e5b4ffd7ebbe3f41b39f316a",
};

static DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+WATER_SHADOW+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 84524, bytes: 20608 },
    bindings: BINDINGS_8,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "3e65a90cd005adf8ca6c6f57c5d8bf9b793844fce07774e073a46fa5893ca9ed",
};

static DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW: Module = Module {
    name: "DrawFloor.vertex+CAUSTICS_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 105132, bytes: 3128 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "71bc0d89bcd428242a6c7e3edd4568ac4229e2cb1f304e3b8b360b0f133bd794",
};

static DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+CAUSTICS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 108260, bytes: 10320 },
    bindings: BINDINGS_9,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "c8e4e9d7562ac4353cf3473f33af424ba62592e51a4b0e71e8a348d4151ceaab",
};

static DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+CAUSTICS_SHADOW+SOLIDS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 118580, bytes: 19992 },
    bindings: BINDINGS_10,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "29285ddc84311a18d5fb61f8f8664f0b7ac4d4e4949aea0b2d3d65251431cc14",
};
