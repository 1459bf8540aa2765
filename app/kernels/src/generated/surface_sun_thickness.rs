// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/sun_thickness.hlsl.
//! Kernels of `surface/sun_thickness.hlsl`.

use super::{FrameLight, Position, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tier, Uniform, bind_draw,
};

/// How much fluid the sun looks through, in spacings, in its parallel projection.
#[derive(Debug)]
pub struct DrawSunThickness<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawSunThickness<'_> {
    const STAGE: &'static str = "draw_sun_thickness";

    fn vertex(&self) -> &'static Module {
        &DRAW_SUN_THICKNESS_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_SUN_THICKNESS_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("positions", Some(self.positions.id)),
                ("light", Some(self.light.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_SUN_THICKNESS_VERTEX, &DRAW_SUN_THICKNESS_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] =
    &[BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } }];

static DRAW_SUN_THICKNESS_VERTEX: Module = Module {
    name: "DrawSunThickness.vertex",
    entry: "SunThicknessVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_sun_thickness.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_thickness.hlsl",
    hash: "1a68f0d634a8dfc48cd6ae2245b2779053cf66ff96d0428694bc4d7e1555b22b",
};

static DRAW_SUN_THICKNESS_FRAGMENT: Module = Module {
    name: "DrawSunThickness.fragment",
    entry: "SunThicknessFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_sun_thickness.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_thickness.hlsl",
    hash: "330fabea2206360ca8c6aea17d41f29cc3b5962c6599e30777d9e8a7a36b4a61",
};
