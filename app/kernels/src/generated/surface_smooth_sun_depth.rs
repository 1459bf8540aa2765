// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_sun_depth.hlsl.
//! Kernels of `surface/smooth_sun_depth.hlsl`.

use super::{AlongKeyword, FrameLight, SurfaceParams};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw};

/// Which variant of [`DrawSmoothSunDepth`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawSmoothSunDepthVariant {
    /// Keyword `ALONG_X` or `ALONG_Y`.
    pub along: AlongKeyword,
}

/// The surface that sunlight meets without the particles' bumps, which would each be a lens: a line
/// fitted to the texels of one surface in a Gaussian's window, one direction a pass, several times. A
/// plane stays as it is, up to its edge. A mean of what lies to both sides would smooth nothing there, and
/// at the outline of a body, which the sun grazes, its particles' bumps would comb the light.
#[derive(Debug)]
pub struct DrawSmoothSunDepth<'a> {
    /// Its variant.
    pub variant: DrawSmoothSunDepthVariant,
    /// `Texture2D<float> sun_depth`.
    pub sun_depth: Tex<'a>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawSmoothSunDepth<'_> {
    const STAGE: &'static str = "draw_smooth_sun_depth";

    fn vertex(&self) -> &'static Module {
        &DRAW_SMOOTH_SUN_DEPTH_VERTEX_WITH_ALONG_X
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.along {
            AlongKeyword::AlongX => Some(&DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_X),
            AlongKeyword::AlongY => Some(&DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_Y),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("sun_depth", Some(self.sun_depth.id)),
                ("light", Some(self.light.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_SMOOTH_SUN_DEPTH_VERTEX_WITH_ALONG_X,
    &DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_X,
    &DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_Y,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "sun_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static DRAW_SMOOTH_SUN_DEPTH_VERTEX_WITH_ALONG_X: Module = Module {
    name: "DrawSmoothSunDepth.vertex+ALONG_X",
    entry: "SmoothSunDepthVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_smooth_sun_depth.vertex+along_x.spv"),
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_sun_depth.hlsl",
    hash: "67dfcd1b3e533a768b5e27af595e7465bce5c1a7e3334055dfd18f7e977b5727",
};

static DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_X: Module = Module {
    name: "DrawSmoothSunDepth.fragment+ALONG_X",
    entry: "SmoothSunDepthFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_sun_depth.fragment+along_x.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_sun_depth.hlsl",
    hash: "fb6e0f0309d812dfd709031f8ae55d299d90b853de4a5c4c56d3e157022bc73f",
};

static DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_Y: Module = Module {
    name: "DrawSmoothSunDepth.fragment+ALONG_Y",
    entry: "SmoothSunDepthFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_smooth_sun_depth.fragment+along_y.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_sun_depth.hlsl",
    hash: "a6b136f976cebfd0bfd925e77ca663617b53ab395d1e827dd16bee1c1bc263ff",
};
