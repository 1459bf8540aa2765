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
    hash: "f37211179fca5d42d4952abdfc5de41d6f1e909afb2191200fc3f6e9e8161f31",
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
    hash: "71c086748ac1e50332ab02d5c161ec51fdb9fabbe4c4869e684c7eff0e85a961",
};
