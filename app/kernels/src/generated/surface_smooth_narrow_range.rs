// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_narrow_range.hlsl.
//! Kernels of `surface/smooth_narrow_range.hlsl`.

use super::{FilterKeyword, FrameView, SurfaceParams};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw};

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

static DRAW_SMOOTH_NARROW_RANGE_VERTEX_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothNarrowRange.vertex+FILTER_X",
    entry: "SmoothNarrowRangeVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_smooth_narrow_range.vertex+filter_x.spv"),
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "3df709182a1c69b0abe9456a127f7c4a0df25330c34cf8f1d35d772a4bae14c1",
};

static DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_X: Module = Module {
    name: "DrawSmoothNarrowRange.fragment+FILTER_X",
    entry: "SmoothNarrowRangeFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_narrow_range.fragment+filter_x.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "45dd9cd0a8e4d19db85dd48382f34fea90d73cba2c92b6e746d58c41b0e60445",
};

static DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_Y: Module = Module {
    name: "DrawSmoothNarrowRange.fragment+FILTER_Y",
    entry: "SmoothNarrowRangeFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_narrow_range.fragment+filter_y.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "58bce4517506c987851e4c122a3073888993f2858ba544c633d0bd6a0da6f347",
};

static DRAW_SMOOTH_NARROW_RANGE_FRAGMENT_WITH_FILTER_PLANE: Module = Module {
    name: "DrawSmoothNarrowRange.fragment+FILTER_PLANE",
    entry: "SmoothNarrowRangeFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_narrow_range.fragment+filter_plane.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_narrow_range.hlsl",
    hash: "64c0e55a15f3ca1102c821d7b2aa702bdc24933966be01bf799a78c310a4954b",
};
