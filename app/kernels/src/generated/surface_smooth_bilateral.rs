// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_bilateral.hlsl.
//! Kernels of `surface/smooth_bilateral.hlsl`.

use super::{FilterKeyword, FrameView, SurfaceParams};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw};

/// Which variant of [`DrawSmoothBilateral`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawSmoothBilateralVariant {
    /// Keyword `FILTER_X` or `FILTER_Y` or `FILTER_PLANE`.
    pub filter: FilterKeyword,
}

/// The bilateral filter (Tomasi & Manduchi 1998) over the fluid's pixels: near in the picture and
/// near in depth counts much. It is not separable; one direction after the other is the usual
/// approximation, and FILTER\_PLANE is the filter itself.
#[derive(Debug)]
pub struct DrawSmoothBilateral<'a> {
    /// Its variant.
    pub variant: DrawSmoothBilateralVariant,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawSmoothBilateral<'_> {
    const STAGE: &'static str = "draw_smooth_bilateral";

    fn vertex(&self) -> &'static Module {
        &DRAW_SMOOTH_BILATERAL_VERTEX_WITH_FILTER_X
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.filter {
            FilterKeyword::FilterX => Some(&DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_X),
            FilterKeyword::FilterY => Some(&DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_Y),
            FilterKeyword::FilterPlane => Some(&DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_PLANE),
        }
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
pub(super) static MODULES: &[&Module] = &[
    &DRAW_SMOOTH_BILATERAL_VERTEX_WITH_FILTER_X,
    &DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_X,
    &DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_Y,
    &DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_PLANE,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static DRAW_SMOOTH_BILATERAL_VERTEX_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothBilateral.vertex+FILTER_X",
    entry: "SmoothBilateralVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_smooth_bilateral.vertex+filter_x.spv"),
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "4d9851d8b75ccd0023199104c98308d1f371cde212debbe913e0773b5c7bc8a4",
};

static DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothBilateral.fragment+FILTER_X",
    entry: "SmoothBilateralFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_bilateral.fragment+filter_x.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "f3f9b411e838145708cb0fd817d82adc35d82588f2d1167f341aaf0182b9042a",
};

static DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_Y: Module = Module {
    name: "DrawSmoothBilateral.fragment+FILTER_Y",
    entry: "SmoothBilateralFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_bilateral.fragment+filter_y.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "6157a8e7de372271141ca79694d4d6ad4f857246902dbb3778c5695ee87c0e70",
};

static DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_PLANE: Module = Module {
    name: "DrawSmoothBilateral.fragment+FILTER_PLANE",
    entry: "SmoothBilateralFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_bilateral.fragment+filter_plane.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "b3f3c65cd5a732cf3b3259c896c74eade3578db601dfd33c2d943d10c8a081f2",
};
