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
    hash: "aac27546dc3d688d29e97eda51241664c0790b46caa9948b751bb7339b60dbca",
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
    hash: "8cb3b4b71df53e1dc4057f1368f046f5cfb95778f4a74c364faa2556c1d4ec42",
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
    hash: "84fd219db6f609a349578a6afabbb0b20ebea8b2d73853bf87d992b423a2dd15",
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
    hash: "8d1abda159fd8d9bebb22eda2ad14617567fb409e3b9797977927df8f53437e1",
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
    hash: "7a15b108b142af383a770c4a2d85dbef5005705cc2c0e1bb0359193879a4c41a",
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
    hash: "c0a0410b9319043aa0fbeec61b4cc41b156b1b93b8f35dac1b133029ced8781a",
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
    hash: "2734e255856ea8b68b57e2339d41db25b17831b868b5f21a4c1d8a1ee81d78a4",
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
    hash: "b78082bbc78a9e71ea6485dc785987f89917d3c2b4dab7bf7cb8ef5011aa2474",
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
    hash: "641acda6098d639a706b9225aa18d56d6308e24c4106aa24943d4dfc64f73e32",
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
    hash: "0b68fde5308185038ace2053e64ebda3c8250b3651b06c0a210b23f9b004234f",
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
    hash: "b99d1b8753f2d977c04752388fac43d00699522ae29d581bf5c54b26fabc63ec",
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
    hash: "327d546c1693bef198c57f0ff3e601da14758dbd2971d9fcaa2666cfaa0bbdfd",
};
