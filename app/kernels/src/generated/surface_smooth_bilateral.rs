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
    hash: "75f89da5b79e0702c7268fe9f2130ebb17fdcbb4f2a5e04bbbae7442440bc1f1",
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
    hash: "cd763c0ea1c1b74a69e19ae891b65a12e41a8861c3f4ac2ee03e5583faabee85",
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
    hash: "3e6087a1915cea69323478388dea05b1f58d16b3dae8a6ca5493f52d17efcb10",
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
    hash: "d6457e28296f7d65ad058e1bafbe90200ec3974ff38479c00830f2f11c6231c9",
};
