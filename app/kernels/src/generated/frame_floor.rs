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
            ShadowKeyword::CausticsShadow => &DRAW_FLOOR_VERTEX_WITH_WATER_SHADOW,
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
    hash: "40f1e1cab3b877f8021d892fa7be9ec02238f5cf25ae72bc9e3503f176fb2c47",
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
    hash: "fd4fdf776789dfe4f59720fdbb32d777b4a68da381504be15e7c3fa9982b97a0",
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
    hash: "bc13b7bc39aea46496f556d4840f70d1193e83cc3b0643ce0c023bf60d23ed1d",
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
    hash: "ca366578eb50ca4bff22178e69b60a9560adcb8ac16d6e3b2e177ed5e70f7b87",
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
    hash: "54f631765723a50d3fd84991dc0b6d6f7d199f277a71cd441c1e337f87fe1fee",
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
    hash: "fa27c45aeaf880b942096b5da70d47bde501769feb350a8de39b0b75fb693558",
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
    hash: "589be9da7796e560a5d7d30bcbc52a8b1a07a7776706dc83a5b137644eb727d1",
};
