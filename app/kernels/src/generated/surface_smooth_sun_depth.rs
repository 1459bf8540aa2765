// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_sun_depth.hlsl.
//! Kernels of `surface/smooth_sun_depth.hlsl`.

use super::{AlongKeyword, FrameLight, SurfaceParams};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

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

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_smooth_sun_depth.deflate"));

static DRAW_SMOOTH_SUN_DEPTH_VERTEX_WITH_ALONG_X: Module = Module {
    name: "DrawSmoothSunDepth.vertex+ALONG_X",
    entry: "SmoothSunDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 572 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_sun_depth.hlsl",
    hash: "5f170d363bfc84494537edfca5ae98faa11d1b2505071f82e3dc3cd11a5b23af",
};

static DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_X: Module = Module {
    name: "DrawSmoothSunDepth.fragment+ALONG_X",
    entry: "SmoothSunDepthFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 572, bytes: 7348 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_sun_depth.hlsl",
    hash: "1945aab997b9e368364bf950df31031ab58966ac9626e6492ecb85fa9f11c07b",
};

static DRAW_SMOOTH_SUN_DEPTH_FRAGMENT_WITH_ALONG_Y: Module = Module {
    name: "DrawSmoothSunDepth.fragment+ALONG_Y",
    entry: "SmoothSunDepthFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 7920, bytes: 7348 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_sun_depth.hlsl",
    hash: "9d995ddc84ea01ce9efe2730d897e2393c76b5328920c6b5970f5b56ba8ef6de",
};
