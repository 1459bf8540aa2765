// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_bilateral.hlsl.
//! Kernels of `surface/smooth_bilateral.hlsl`.

use super::{FilterKeyword, FrameView, SurfaceParams};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

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

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_smooth_bilateral.deflate"));

static DRAW_SMOOTH_BILATERAL_VERTEX_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothBilateral.vertex+FILTER_X",
    entry: "SmoothBilateralVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 572 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "2fb1fad3bd6a9eb74202901e10e51fe07705da426ffed626bbbc88e82407ac82",
};

static DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothBilateral.fragment+FILTER_X",
    entry: "SmoothBilateralFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 572, bytes: 4424 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "d5935d1f4d1386fe2bdf71f2b299e1b3d899f75377465eadcf5d930649e5ef60",
};

static DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_Y: Module = Module {
    name: "DrawSmoothBilateral.fragment+FILTER_Y",
    entry: "SmoothBilateralFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4996, bytes: 4424 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "564588d341470e281ac88cc71dfcd74328c30ee623848a82c9deb67be80f7f1f",
};

static DRAW_SMOOTH_BILATERAL_FRAGMENT_WITH_FILTER_PLANE: Module = Module {
    name: "DrawSmoothBilateral.fragment+FILTER_PLANE",
    entry: "SmoothBilateralFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 9420, bytes: 4716 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_bilateral.hlsl",
    hash: "355c5daf21581a1680d77633d68b010ed2b2550dc4409e56d988145a88cb4370",
};
