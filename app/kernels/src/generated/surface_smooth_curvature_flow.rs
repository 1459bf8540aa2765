// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_curvature_flow.hlsl.
//! Kernels of `surface/smooth_curvature_flow.hlsl`.

use super::{FrameView, SurfaceParams};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// One step of screen-space curvature flow (van der Laan, Green & Sainz 2009): the surface moves
/// along the line of sight by its mean curvature, dz/dt = 2H, as surface tension would have it.
/// With pixels p = z a wide in the world, D = z\_x^2 + z\_y^2 + p^2 (eq. 5 with square pixels) and
/// 2H = (E\_x + E\_y) / (D^1.5 p), E\_x = z\_xx D - z\_x D\_x / 2 (eq. 6-8, here in metres so that a time
/// is an area, the same near and far).
#[derive(Debug)]
pub struct DrawSmoothCurvatureFlow<'a> {
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawSmoothCurvatureFlow<'_> {
    const STAGE: &'static str = "draw_smooth_curvature_flow";

    fn vertex(&self) -> &'static Module {
        &DRAW_SMOOTH_CURVATURE_FLOW_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_SMOOTH_CURVATURE_FLOW_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("inverse_depth", Some(self.inverse_depth.id)),
                ("view", Some(self.view.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_SMOOTH_CURVATURE_FLOW_VERTEX, &DRAW_SMOOTH_CURVATURE_FLOW_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_smooth_curvature_flow.deflate"));

static DRAW_SMOOTH_CURVATURE_FLOW_VERTEX: Module = Module {
    name: "DrawSmoothCurvatureFlow.vertex",
    entry: "SmoothCurvatureFlowVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 580 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_curvature_flow.hlsl",
    hash: "59a319e110e11c1d44d0cc046663eaad8d91d8a4b81d3cf0b8e73e9900ad6124",
};

static DRAW_SMOOTH_CURVATURE_FLOW_FRAGMENT: Module = Module {
    name: "DrawSmoothCurvatureFlow.fragment",
    entry: "SmoothCurvatureFlowFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 580, bytes: 8232 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_curvature_flow.hlsl",
    hash: "6c1bf93a4021b28d2af7040fd3a6817bbe343f3c0f0e81e8f91646b04b68c655",
};
