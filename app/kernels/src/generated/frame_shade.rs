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
            (ColorKeyword::Off, true) => &DRAW_SHADE_VERTEX,
            (ColorKeyword::ColorFluid, false) => &DRAW_SHADE_VERTEX_WITH_COLOR_FLUID,
            (ColorKeyword::ColorFluid, true) => &DRAW_SHADE_VERTEX_WITH_COLOR_FLUID,
            (ColorKeyword::ColorDensity, false) => &DRAW_SHADE_VERTEX,
            (ColorKeyword::ColorDensity, true) => &DRAW_SHADE_VERTEX,
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

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "solids_shadow_map", slot: 7, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_3: &[BindingInfo] = &[BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 2, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "seen", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "positions", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 2, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "solids_shadow_map", slot: 6, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_6: &[BindingInfo] = &[
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
    BindingInfo { name: "solids_shadow_map", slot: 7, kind: BindingKind::Texture { filterable: false } },
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
    hash: "001a390197f65917de3ecd22a53c39fb89628b785e4fc59a10b8e416fe8f5f0d",
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
    hash: "19e43571d9142cc1a2dc8822421004bccab249847a160f541494c50093f20d67",
};

static DRAW_SHADE_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawShade.fragment+SOLIDS_SHADOW",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 12608, bytes: 14320 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "3a0ee22053a6e322c0f42e29c58535072a20874a11115573dd5786199f18a6fb",
};

static DRAW_SHADE_VERTEX_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.vertex+COLOR_FLUID",
    entry: "ShadeVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 26928, bytes: 1716 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "d45b7de36deadd7952949b3e4b702f7b301dc646196bab2c047a41b6fff83f54",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.fragment+COLOR_FLUID",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 28644, bytes: 10332 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "a18a624b28c7d36276064c82ab8d83eef69df48b61a5b66e7fa8cff77cff7ac6",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawShade.fragment+COLOR_FLUID+SOLIDS_SHADOW",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 38976, bytes: 13792 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "307f63c56521c26bcea26f22bb711d5a225a6fe2b2aae4a81ac559d70a691df6",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY: Module = Module {
    name: "DrawShade.fragment+COLOR_DENSITY",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 52768, bytes: 10416 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "b1f93cbcdb51a3907866728dc5160fdd79059dd2e8bca868dbc9ec1e89c11afe",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_DENSITY_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawShade.fragment+COLOR_DENSITY+SOLIDS_SHADOW",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 63184, bytes: 13860 },
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "e74c256f489bf3920d7261f2ff519a1f180d9e4aa967f140311e887018b5bf04",
};
