// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/shade.hlsl.
//! Kernels of `frame/shade.hlsl`.

use super::{ColorKeyword, FrameLight, FrameStyle, FrameView, Position, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawShade`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawShadeVariant {
    /// Keyword `COLOR_FLUID` or `COLOR_DENSITY`.
    pub color: ColorKeyword,
}

/// The particles' colours: each pixel in which one is seen is shaded once.
#[derive(Debug)]
pub struct DrawShade<'a> {
    /// Its variant.
    pub variant: DrawShadeVariant,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// index + 1 of the particle seen in a pixel, 0 where there is none
    ///
    /// `Texture2D<float> seen`.
    pub seen: Tex<'a>,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Option<Buf<'a, Velocity>>,
    /// `Texture2D<float> shadow_map`.
    pub shadow_map: Tex<'a>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `StructuredBuffer<float> density_ratios`.
    pub density_ratios: Option<Buf<'a, f32>>,
}

impl Draw for DrawShade<'_> {
    const STAGE: &'static str = "draw_shade";

    fn vertex(&self) -> &'static Module {
        match self.variant.color {
            ColorKeyword::Off => &DRAW_SHADE_VERTEX,
            ColorKeyword::ColorFluid => &DRAW_SHADE_VERTEX_WITH_COLOR_FLUID,
            ColorKeyword::ColorDensity => &DRAW_SHADE_VERTEX,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.color {
            ColorKeyword::Off => Some(&DRAW_SHADE_FRAGMENT),
            ColorKeyword::ColorFluid => Some(&DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID),
            ColorKeyword::ColorDensity => Some(&DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("view", Some(self.view.id)),
                ("seen", Some(self.seen.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", self.velocities.as_ref().map(|bound| bound.id)),
                ("shadow_map", Some(self.shadow_map.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
                ("density_ratios", self.density_ratios.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_SHADE_VERTEX,
    &DRAW_SHADE_FRAGMENT,
    &DRAW_SHADE_VERTEX_WITH_COLOR_FLUID,
    &DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID,
    &DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY,
];

static BINDINGS_0: &[BindingInfo] = &[BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_2: &[BindingInfo] = &[BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 2, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "density_ratios",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "shadow_map", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_shade.deflate"));

static DRAW_SHADE_VERTEX: Module = Module {
    name: "DrawShade.vertex",
    entry: "ShadeVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 1716 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "f85a69685e60810d46deb6e92312164775a6e1ef8326f2ee06b2466f7c980385",
};

static DRAW_SHADE_FRAGMENT: Module = Module {
    name: "DrawShade.fragment",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 1716, bytes: 10892 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "83c25561f1ecdf05c9814e88323cfac54267bc434be44c7062895e23411da1e6",
};

static DRAW_SHADE_VERTEX_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.vertex+COLOR_FLUID",
    entry: "ShadeVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 12608, bytes: 1716 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "0a845c94229fc27e83fc573ef48fa91f0e8c41baf1f8582efe26b7bde001a39e",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.fragment+COLOR_FLUID",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 14324, bytes: 10332 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "a4d8a4dadbab0fd8b32f8c90018ccd66d86c89e20cf2779fd66344ea8c378551",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY: Module = Module {
    name: "DrawShade.fragment+COLOR_DENSITY",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 24656, bytes: 10416 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "a4dcb15f2bb58498bdb1a288dd24f94cc987df5802d13d76e61dba4714dc72c9",
};
