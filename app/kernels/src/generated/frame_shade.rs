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
    /// Keyword `SOLIDS_SHADOW`.
    pub solids_shadow: bool,
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
    /// `Texture2D<float> solids_shadow_map`.
    pub solids_shadow_map: Option<Tex<'a>>,
    /// `StructuredBuffer<float> density_ratios`.
    pub density_ratios: Option<Buf<'a, f32>>,
}

impl Draw for DrawShade<'_> {
    const STAGE: &'static str = "draw_shade";

    fn vertex(&self) -> &'static Module {
        match (self.variant.color, self.variant.solids_shadow) {
            (ColorKeyword::Off, false) => &DRAW_SHADE_VERTEX,
            (ColorKeyword::Off, true) => &DRAW_SHADE_VERTEX_WITH_SOLIDS_SHADOW,
            (ColorKeyword::ColorFluid, false) => &DRAW_SHADE_VERTEX_WITH_COLOR_FLUID,
            (ColorKeyword::ColorFluid, true) => &DRAW_SHADE_VERTEX,
            (ColorKeyword::ColorDensity, false) => &DRAW_SHADE_VERTEX,
            (ColorKeyword::ColorDensity, true) => &DRAW_SHADE_VERTEX_WITH_SOLIDS_SHADOW,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match (self.variant.color, self.variant.solids_shadow) {
            (ColorKeyword::Off, false) => Some(&DRAW_SHADE_FRAGMENT),
            (ColorKeyword::Off, true) => Some(&DRAW_SHADE_FRAGMENT_WITH_SOLIDS_SHADOW),
            (ColorKeyword::ColorFluid, false) => Some(&DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID),
            (ColorKeyword::ColorFluid, true) => Some(&DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID_WITH_SOLIDS_SHADOW),
            (ColorKeyword::ColorDensity, false) => Some(&DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY),
            (ColorKeyword::ColorDensity, true) => Some(&DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY_WITH_SOLIDS_SHADOW),
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
                ("solids_shadow_map", self.solids_shadow_map.as_ref().map(|bound| bound.id)),
                ("density_ratios", self.density_ratios.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_SHADE_VERTEX,
    &DRAW_SHADE_FRAGMENT,
    &DRAW_SHADE_VERTEX_WITH_SOLIDS_SHADOW,
    &DRAW_SHADE_FRAGMENT_WITH_SOLIDS_SHADOW,
    &DRAW_SHADE_VERTEX_WITH_COLOR_FLUID,
    &DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID,
    &DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID_WITH_SOLIDS_SHADOW,
    &DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY,
    &DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY_WITH_SOLIDS_SHADOW,
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

static BINDINGS_2: &[BindingInfo] = &[BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "solids_shadow_map", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_4: &[BindingInfo] = &[BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 2, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_6: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 2, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "solids_shadow_map", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_7: &[BindingInfo] = &[
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

static BINDINGS_8: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "density_ratios",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "shadow_map", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "solids_shadow_map", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
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
    hash: "3e7b8651eedf553c07edba6cab50adbf95cdbc31d38e031db4f3bf25224e8adb",
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
    hash: "c0a933e0257804006df6cbe2e62bf25c0d8a590af17d633c07f113cb0fb8b053",
};

static DRAW_SHADE_VERTEX_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawShade.vertex+SOLIDS_SHADOW",
    entry: "ShadeVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 12608, bytes: 1716 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "efef35e292602659c030666948d10617be3b67debcac67ab61fbeff4242c3f29",
};

static DRAW_SHADE_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawShade.fragment+SOLIDS_SHADOW",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 14324, bytes: 13268 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "7902be8dec370d93d91f92b3cc0d052d2c2bb27a0e2423c65cda59b1e87fa3e4",
};

static DRAW_SHADE_VERTEX_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.vertex+COLOR_FLUID",
    entry: "ShadeVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 27592, bytes: 1716 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "93d6321a710b5055cea1614f0590638c5d5ab481adb891daff7457ef4bf67967",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.fragment+COLOR_FLUID",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 29308, bytes: 10332 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "85518e43787f4dcd3b86abc35400cf4855fb8f6ee7a649213eba3cc0e7d63021",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawShade.fragment+COLOR_FLUID+SOLIDS_SHADOW",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 39640, bytes: 12740 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "20810627e2b8fbdd005d8fc7cee9bc786ebfcd3ae00e444145f722647f252c7f",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY: Module = Module {
    name: "DrawShade.fragment+COLOR_DENSITY",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 52380, bytes: 10416 },
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "8af4b10f30113e8c2847017344d283d98b2e1ed47bca46d2d275c323277c4225",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawShade.fragment+COLOR_DENSITY+SOLIDS_SHADOW",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 62796, bytes: 12808 },
    bindings: BINDINGS_8,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "f45a96e0db58b9fded28179267efce752091e055bcabfc071ff94a2dce702fe6",
};
