// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/floor.hlsl.
//! Kernels of `frame/floor.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, ShadowKeyword, SurfaceParams, WaterStyle};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw};

/// Which variant of [`DrawFloor`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawFloorVariant {
    /// Keyword `POINTS_SHADOW` or `WATER_SHADOW` or `CAUSTICS_SHADOW`.
    pub shadow: ShadowKeyword,
}

/// The floor under the domain: satin tiles with the fluid's soft shadow, melting into the horizon.
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
        match self.variant.shadow {
            ShadowKeyword::Off => &DRAW_FLOOR_VERTEX,
            ShadowKeyword::PointsShadow => &DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW,
            ShadowKeyword::WaterShadow => &DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW,
            ShadowKeyword::CausticsShadow => &DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.shadow {
            ShadowKeyword::Off => Some(&DRAW_FLOOR_FRAGMENT),
            ShadowKeyword::PointsShadow => Some(&DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW),
            ShadowKeyword::WaterShadow => Some(&DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW),
            ShadowKeyword::CausticsShadow => Some(&DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW),
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
    &DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW,
    &DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW,
    &DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW,
    &DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW,
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
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "shadow_map", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "sun_thickness", slot: 0, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 1, kind: BindingKind::Sampler },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_6: &[BindingInfo] = &[
    BindingInfo { name: "sun_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "caustics", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 2, kind: BindingKind::Sampler },
    BindingInfo { name: "surface", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static DRAW_FLOOR_VERTEX: Module = Module {
    name: "DrawFloor.vertex",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_floor.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "d3c72d5a7637113d166d5add1126ba99a06fddef12b3ff49641c74a75cd283c6",
};

static DRAW_FLOOR_FRAGMENT: Module = Module {
    name: "DrawFloor.fragment",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_floor.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "eeee6c8d087c6bc4db8c65bf20c9f6cc9944bd463621c8ce67b60bd9b9f66174",
};

static DRAW_FLOOR_VERTEX_WITH_POINTS_SHADOW: Module = Module {
    name: "DrawFloor.vertex+POINTS_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_floor.vertex+points_shadow.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "e28f52d3129fac30451b48da057ed6d0402debf178b433c6429c4f63ca903631",
};

static DRAW_FLOOR_FRAGMENT_WITH_POINTS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+POINTS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_floor.fragment+points_shadow.spv"),
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "5a634dd7f439f63404ef07ca7126f3d71b59b541f7ff6bd1483fc8d600e17da3",
};

static DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW: Module = Module {
    name: "DrawFloor.vertex+WATER_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_floor.vertex+water_shadow.spv"),
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "ef27167b68ef8e765b6d51815583505db7dc6afabf0065e8e8b2fa8c555e93ce",
};

static DRAW_FLOOR_FRAGMENT_WITH_WATER_SHADOW: Module = Module {
    name: "DrawFloor.fragment+WATER_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_floor.fragment+water_shadow.spv"),
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "ee2a6355f4ca0d7e9282871b260d8ed46d435ece49480ed5a96685f9d7a59285",
};

static DRAW_FLOOR_VERTEX_WITH_CAUSTICS_SHADOW: Module = Module {
    name: "DrawFloor.vertex+CAUSTICS_SHADOW",
    entry: "FloorVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_floor.vertex+caustics_shadow.spv"),
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "73dc70a83200c981997c1baf580e548e89d3b87635dd678e6d49749a0bec0829",
};

static DRAW_FLOOR_FRAGMENT_WITH_CAUSTICS_SHADOW: Module = Module {
    name: "DrawFloor.fragment+CAUSTICS_SHADOW",
    entry: "FloorFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_floor.fragment+caustics_shadow.spv"),
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/floor.hlsl",
    hash: "e3b1c9cfcef2b24623f5117f8dc7ab94ac498e5cbe39d48dd346b79930a31512",
};
