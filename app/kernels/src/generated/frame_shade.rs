// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/shade.hlsl.
//! Kernels of `frame/shade.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, Position, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawShade`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawShadeVariant {
    /// Keyword `COLOR_FLUID`.
    pub color_fluid: bool,
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
}

impl Draw for DrawShade<'_> {
    const STAGE: &'static str = "draw_shade";

    fn vertex(&self) -> &'static Module {
        if self.variant.color_fluid { &DRAW_SHADE_VERTEX_WITH_COLOR_FLUID } else { &DRAW_SHADE_VERTEX }
    }
    fn fragment(&self) -> Option<&'static Module> {
        if self.variant.color_fluid { Some(&DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID) } else { Some(&DRAW_SHADE_FRAGMENT) }
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

static DRAW_SHADE_VERTEX: Module = Module {
    name: "DrawShade.vertex",
    entry: "ShadeVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_shade.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "38f9adf62157ee93cebf8e3d317d79b59f6b9b169e3f204a4470b340478c3a8a",
};

static DRAW_SHADE_FRAGMENT: Module = Module {
    name: "DrawShade.fragment",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_shade.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "bc14b63dcb22dd4eaf4ce96f918e77106c0e424e019e3053f34bc585af37f88c",
};

static DRAW_SHADE_VERTEX_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.vertex+COLOR_FLUID",
    entry: "ShadeVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_shade.vertex+color_fluid.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "f1b0e16c13c65544f8bfa62f5206e0e3b22c2c26a36ab168cd6236b633405190",
};

static DRAW_SHADE_FRAGMENT_WITH_COLOR_FLUID: Module = Module {
    name: "DrawShade.fragment+COLOR_FLUID",
    entry: "ShadeFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_shade.fragment+color_fluid.spv"),
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/shade.hlsl",
    hash: "1200547306d6696d1178e0c07b54469492b865c2196b11b1586a6aa4a2c5c9bb",
};
