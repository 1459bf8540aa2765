// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/sun_thickness.hlsl.
//! Kernels of `surface/sun_thickness.hlsl`.

use super::{Ellipsoid, FrameLight, Position, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawSunThickness`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawSunThicknessVariant {
    /// Keyword `ELLIPSOID_CENTERS`.
    pub ellipsoid_centers: bool,
}

/// How much fluid the sun looks through, in spacings, in its parallel projection.
#[derive(Debug)]
pub struct DrawSunThickness<'a> {
    /// Its variant.
    pub variant: DrawSunThicknessVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Option<Buf<'a, Position>>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
    /// `StructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: Option<Buf<'a, Ellipsoid>>,
}

impl Draw for DrawSunThickness<'_> {
    const STAGE: &'static str = "draw_sun_thickness";

    fn vertex(&self) -> &'static Module {
        if self.variant.ellipsoid_centers {
            &DRAW_SUN_THICKNESS_VERTEX_WITH_ELLIPSOID_CENTERS
        } else {
            &DRAW_SUN_THICKNESS_VERTEX
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_SUN_THICKNESS_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("positions", self.positions.as_ref().map(|bound| bound.id)),
                ("light", Some(self.light.id)),
                ("surface", Some(self.surface.id)),
                ("ellipsoids", self.ellipsoids.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&DRAW_SUN_THICKNESS_VERTEX, &DRAW_SUN_THICKNESS_FRAGMENT, &DRAW_SUN_THICKNESS_VERTEX_WITH_ELLIPSOID_CENTERS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] =
    &[BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } }];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "ellipsoids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_sun_thickness.deflate"));

static DRAW_SUN_THICKNESS_VERTEX: Module = Module {
    name: "DrawSunThickness.vertex",
    entry: "SunThicknessVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3708 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_thickness.hlsl",
    hash: "5cce0e00cf0ca561f36165bb8aced83b3b4bb0d7d490445e9a1c21a0ee5177d7",
};

static DRAW_SUN_THICKNESS_FRAGMENT: Module = Module {
    name: "DrawSunThickness.fragment",
    entry: "SunThicknessFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 3708, bytes: 1564 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_thickness.hlsl",
    hash: "064c9e28def58f47a6ffc63684fb9ac8f99aeed7f924c9a4a306926adfee7195",
};

static DRAW_SUN_THICKNESS_VERTEX_WITH_ELLIPSOID_CENTERS: Module = Module {
    name: "DrawSunThickness.vertex+ELLIPSOID_CENTERS",
    entry: "SunThicknessVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 5272, bytes: 3816 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_thickness.hlsl",
    hash: "012e90f2e68942b3a30287c140cb60c2453ce4a90be436deca62785199885372",
};
