// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_narrow_range.hlsl.
//! Kernels of `surface/smooth_narrow_range.hlsl`.

use super::{FilterKeyword, FrameView, SurfaceParams};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawSmoothNarrowRange`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawSmoothNarrowRangeVariant {
    /// Keyword `FILTER_X` or `FILTER_Y` or `FILTER_PLANE`.
    pub filter: FilterKeyword,
}

/// The narrow-range filter (Truong & Yuksel 2018): a Gaussian that passes over what lies in front
/// (with its mirror image, so that nothing leans to one side), takes what lies behind as a little
/// behind, and widens the range as it goes along a slope. One direction a pass; FILTER\_PLANE is the small
/// filter of two dimensions that takes away the streaks of both.
#[derive(Debug)]
pub struct DrawSmoothNarrowRange<'a> {
    /// Its variant.
    pub variant: DrawSmoothNarrowRangeVariant,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawSmoothNarrowRange<'_> {
    const STAGE: &'static str = "draw_smooth_narrow_range";

    fn vertex(&self) -> &'static Module {
        &DRAW_SMOOTH_NARROW_RANGE_VERTEX_WITH_FILTER_X
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.filter {
            FilterKeyword::FilterX => Some(&DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_X),
            FilterKeyword::FilterY => Some(&DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_Y),
            FilterKeyword::FilterPlane => Some(&DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_PLANE),
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
    &DRAW_SMOOTH_NARROW_RANGE_VERTEX_WITH_FILTER_X,
    &DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_X,
    &DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_Y,
    &DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_PLANE,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_smooth_narrow_range.deflate"));

static DRAW_SMOOTH_NARROW_RANGE_VERTEX_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothNarrowRange.vertex+FILTER_X",
    entry: "SmoothNarrowRangeVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 572 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "2e6fd718819c3810bd2b1e2885624fb88517e8a58bdcfad490ea0db6451207a5",
};

static DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothNarrowRange.fragment+FILTER_X",
    entry: "SmoothNarrowRangeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 572, bytes: 5496 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "0df5e7e27f96184d56c9a0e44fc81900d6b72522f0f7a34e554d79fd9e3e889a",
};

static DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_Y: Module = Module {
    name: "DrawSmoothNarrowRange.fragment+FILTER_Y",
    entry: "SmoothNarrowRangeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 6068, bytes: 5496 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "18192fc1b1990980be2d588d45b3a0c89f023e9ce718e3ca99ad85cb60244b94",
};

static DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_PLANE: Module = Module {
    name: "DrawSmoothNarrowRange.fragment+FILTER_PLANE",
    entry: "SmoothNarrowRangeFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 11564, bytes: 67008 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "0e12554bb0591a9be025f90b26f759c6cd25c75214ade1a97ce56ad5d6279c74",
};
