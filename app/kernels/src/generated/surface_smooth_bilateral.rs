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
    hash: "cc20bf169a693dcdb5580d6b6ce6a379960baad74175a73049be8b8bbabd0764",
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
    hash: "b608a71d3c67033b91b8d792359b12402132247bd85b638500621d05f0fbe63a",
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
    hash: "b34e2b9a5b846cd82834e8b4ec6b6cb09ecf9c442e0ccd0990071bdae1bdbef8",
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
    hash: "832f31815f924afe0ab19409b5024d6d3577427c922afb65bfdcb703ec58d5f8",
};
