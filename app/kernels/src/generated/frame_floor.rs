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
    hash: "72b8ee7732248e0f3315b41a990d331bda7fcc0e617bc090a5e9d4cbc4535c70",
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
    hash: "949ab5044e77e254a75e8c93a4ca59bc0c274469f05b234f0d6904af6abfd6f0",
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
    hash: "c82389ff27f36c1a9fbb726bbb3fcbeeb3fd8114179752ceb9e41b99354c203f",
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
    hash: "04ce8b25b859f5ef82537c4b7ea6233e57a4406ed739282f4db51c2c96d96b5f",
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
    hash: "ea6d797b0e215fccac6e6a39221420f7ed5c3e3fe1fea5b163fa8abd1896ca40",
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
    hash: "4f8a402953a2f7e1d0f3314c6bd11bd2c04467c689edfdfdc8110651ef9601ef",
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
    hash: "788fa1aef36fd1966f00d445f7316e9ce1fd62b0a957e7bc4191f7139b911c97",
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
    hash: "00d90a0f962f3781a8d82e5050c0bd76195aa88fab39eb719d75bdabf3315d07",
};
