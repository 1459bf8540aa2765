// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_gaussian.hlsl.
//! Kernels of `surface/smooth_gaussian.hlsl`.

use super::{AlongKeyword, FrameView, SurfaceParams};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawSmoothGaussian`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawSmoothGaussianVariant {
    /// Keyword `ALONG_X` or `ALONG_Y`.
    pub along: AlongKeyword,
}

/// A plain Gaussian over the fluid's pixels, one direction a pass: the baseline. It runs near
/// surfaces into far ones.
#[derive(Debug)]
pub struct DrawSmoothGaussian<'a> {
    /// Its variant.
    pub variant: DrawSmoothGaussianVariant,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawSmoothGaussian<'_> {
    const STAGE: &'static str = "draw_smooth_gaussian";

    fn vertex(&self) -> &'static Module {
        &DRAW_SMOOTH_GAUSSIAN_VERTEX_WITH_ALONG_X
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.along {
            AlongKeyword::AlongX => Some(&DRAW_SMOOTH_GAUSSIAN_FRAGMENT_WITH_ALONG_X),
            AlongKeyword::AlongY => Some(&DRAW_SMOOTH_GAUSSIAN_FRAGMENT_WITH_ALONG_Y),
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
    &DRAW_SMOOTH_GAUSSIAN_VERTEX_WITH_ALONG_X,
    &DRAW_SMOOTH_GAUSSIAN_FRAGMENT_WITH_ALONG_X,
    &DRAW_SMOOTH_GAUSSIAN_FRAGMENT_WITH_ALONG_Y,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_smooth_gaussian.deflate"));

static DRAW_SMOOTH_GAUSSIAN_VERTEX_WITH_ALONG_X: Module = Module {
    name: "DrawSmoothGaussian.vertex+ALONG_X",
    entry: "SmoothGaussianVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 572 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_gaussian.hlsl",
    hash: "8ea8cb2dc023203bd0540cb4382257bb09523732d341431ce91978e98aad37e1",
};

static DRAW_SMOOTH_GAUSSIAN_FRAGMENT_WITH_ALONG_X: Module = Module {
    name: "DrawSmoothGaussian.fragment+ALONG_X",
    entry: "SmoothGaussianFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 572, bytes: 4432 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_gaussian.hlsl",
    hash: "7fa8d3d987c98029800a3137f5e9c2790032c76717c9044b316c85e8d1bafd2b",
};

static DRAW_SMOOTH_GAUSSIAN_FRAGMENT_WITH_ALONG_Y: Module = Module {
    name: "DrawSmoothGaussian.fragment+ALONG_Y",
    entry: "SmoothGaussianFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 5004, bytes: 4432 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_gaussian.hlsl",
    hash: "c21f56b6a7726f803e7842a5cad8856ccdb8a783dddf7b4e439c0534b4203324",
};
