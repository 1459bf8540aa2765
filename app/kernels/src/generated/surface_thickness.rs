// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/thickness.hlsl.
//! Kernels of `surface/thickness.hlsl`.

use super::{Ellipsoid, FrameView, Position, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawThickness`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawThicknessVariant {
    /// Keyword `ELLIPSOID_CENTERS`.
    pub ellipsoid_centers: bool,
}

/// How much fluid each pixel looks through, in spacings: every particle spreads its volume d^3 over a
/// disc, and the discs add up. What overlapping spheres count twice a volume does not.
#[derive(Debug)]
pub struct DrawThickness<'a> {
    /// Its variant.
    pub variant: DrawThicknessVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Option<Buf<'a, Position>>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
    /// `Texture2D<float4> opaque_planes`.
    pub opaque_planes: Tex<'a>,
    /// `StructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: Option<Buf<'a, Ellipsoid>>,
}

impl Draw for DrawThickness<'_> {
    const STAGE: &'static str = "draw_thickness";

    fn vertex(&self) -> &'static Module {
        if self.variant.ellipsoid_centers {
            &DRAW_THICKNESS_VERTEX_WITH_ELLIPSOID_CENTERS
        } else {
            &DRAW_THICKNESS_VERTEX
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_THICKNESS_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("positions", self.positions.as_ref().map(|bound| bound.id)),
                ("view", Some(self.view.id)),
                ("surface", Some(self.surface.id)),
                ("opaque_planes", Some(self.opaque_planes.id)),
                ("ellipsoids", self.ellipsoids.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&DRAW_THICKNESS_VERTEX, &DRAW_THICKNESS_FRAGMENT, &DRAW_THICKNESS_VERTEX_WITH_ELLIPSOID_CENTERS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "opaque_planes", slot: 3, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "ellipsoids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_thickness.deflate"));

static DRAW_THICKNESS_VERTEX: Module = Module {
    name: "DrawThickness.vertex",
    entry: "ThicknessVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4100 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/thickness.hlsl",
    hash: "ae08f4c70c52f8a110ee4fe43f47b0602e4d2c26010198cfe5750caba5079be2",
};

static DRAW_THICKNESS_FRAGMENT: Module = Module {
    name: "DrawThickness.fragment",
    entry: "ThicknessFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4100, bytes: 2272 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/thickness.hlsl",
    hash: "23e70b42eb53ea97899ee234e076e49930e493d3d552cc6b949750a2c13b093a",
};

static DRAW_THICKNESS_VERTEX_WITH_ELLIPSOID_CENTERS: Module = Module {
    name: "DrawThickness.vertex+ELLIPSOID_CENTERS",
    entry: "ThicknessVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 6372, bytes: 4208 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/thickness.hlsl",
    hash: "5b84756a5db5f532314863dc72e2bebda9fb742d30190eed13c0663ec41c9ac6",
};
