// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/thickness.hlsl.
//! Kernels of `surface/thickness.hlsl`.

use super::{FrameView, Position, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tier, Uniform, bind_draw,
};

/// How much fluid each pixel looks through, in spacings: every particle spreads its volume d^3 over a
/// disc, and the discs add up. What overlapping spheres count twice a volume does not.
#[derive(Debug)]
pub struct DrawThickness<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawThickness<'_> {
    const STAGE: &'static str = "draw_thickness";

    fn vertex(&self) -> &'static Module {
        &DRAW_THICKNESS_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_THICKNESS_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[("positions", Some(self.positions.id)), ("view", Some(self.view.id)), ("surface", Some(self.surface.id))],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_THICKNESS_VERTEX, &DRAW_THICKNESS_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] =
    &[BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } }];

static DRAW_THICKNESS_VERTEX: Module = Module {
    name: "DrawThickness.vertex",
    entry: "ThicknessVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_thickness.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/thickness.hlsl",
    hash: "6dd92c4832984d925936e8fe05a4208a7ae880f517eaf4e73ee7f9c126ce4243",
};

static DRAW_THICKNESS_FRAGMENT: Module = Module {
    name: "DrawThickness.fragment",
    entry: "ThicknessFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_thickness.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/thickness.hlsl",
    hash: "6464552f325eae00a0151390f4243df57f35492ef802cc2ec02614d4c57d804f",
};
