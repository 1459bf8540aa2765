// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/fluid_depth.hlsl.
//! Kernels of `surface/fluid_depth.hlsl`.

use super::{Ellipsoid, FrameView, ListHead, Position, ShapeKeyword, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawFluidDepth`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawFluidDepthVariant {
    /// Keyword `SPRAY_SHAPE` or `ELLIPSOID_SHAPE`.
    pub shape: ShapeKeyword,
}

/// The nearest of all particles' spheres, or ellipsoids (surface/anisotropy.compute), in each pixel, as
/// inverse\_depth. At the walls they are cut off: there the water is as flat as the wall.
#[derive(Debug)]
pub struct DrawFluidDepth<'a> {
    /// Its variant.
    pub variant: DrawFluidDepthVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Option<Buf<'a, Position>>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Option<Buf<'a, ListHead>>,
    /// `StructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: Option<Buf<'a, Ellipsoid>>,
}

impl Draw for DrawFluidDepth<'_> {
    const STAGE: &'static str = "draw_fluid_depth";

    fn vertex(&self) -> &'static Module {
        match self.variant.shape {
            ShapeKeyword::Off => &DRAW_FLUID_DEPTH_VERTEX,
            ShapeKeyword::SprayShape => &DRAW_FLUID_DEPTH_VERTEX_WITH_SPRAY_SHAPE,
            ShapeKeyword::EllipsoidShape => &DRAW_FLUID_DEPTH_VERTEX_WITH_ELLIPSOID_SHAPE,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.shape {
            ShapeKeyword::Off => Some(&DRAW_FLUID_DEPTH_FRAGMENT),
            ShapeKeyword::SprayShape => Some(&DRAW_FLUID_DEPTH_FRAGMENT_WITH_SPRAY_SHAPE),
            ShapeKeyword::EllipsoidShape => Some(&DRAW_FLUID_DEPTH_FRAGMENT),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("positions", self.positions.as_ref().map(|bound| bound.id)),
                ("view", Some(self.view.id)),
                ("surface", Some(self.surface.id)),
                ("list_heads", self.list_heads.as_ref().map(|bound| bound.id)),
                ("ellipsoids", self.ellipsoids.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_FLUID_DEPTH_VERTEX,
    &DRAW_FLUID_DEPTH_FRAGMENT,
    &DRAW_FLUID_DEPTH_VERTEX_WITH_SPRAY_SHAPE,
    &DRAW_FLUID_DEPTH_FRAGMENT_WITH_SPRAY_SHAPE,
    &DRAW_FLUID_DEPTH_VERTEX_WITH_ELLIPSOID_SHAPE,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "list_heads", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "ellipsoids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_fluid_depth.deflate"));

static DRAW_FLUID_DEPTH_VERTEX: Module = Module {
    name: "DrawFluidDepth.vertex",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4148 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "e75f3258295e239f9bc874ffea427d45d44af8a1596749c7574a9d22bebec6d3",
};

static DRAW_FLUID_DEPTH_FRAGMENT: Module = Module {
    name: "DrawFluidDepth.fragment",
    entry: "FluidDepthFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4148, bytes: 3348 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "4a6faac7ac680826c1471fecd0fde3c2fc5bed93117fc520390065f5a1b49af3",
};

static DRAW_FLUID_DEPTH_VERTEX_WITH_SPRAY_SHAPE: Module = Module {
    name: "DrawFluidDepth.vertex+SPRAY_SHAPE",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 7496, bytes: 4768 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "0fe0cb23bbbb247c5d3ba700271a21879615a802c76e6459d76a47a0d05b6d84",
};

static DRAW_FLUID_DEPTH_FRAGMENT_WITH_SPRAY_SHAPE: Module = Module {
    name: "DrawFluidDepth.fragment+SPRAY_SHAPE",
    entry: "FluidDepthFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 12264, bytes: 3348 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "22470cba2ec4e94ed59519dc9a5b5e417345dbbaa7f173c2474a35d244b7b220",
};

static DRAW_FLUID_DEPTH_VERTEX_WITH_ELLIPSOID_SHAPE: Module = Module {
    name: "DrawFluidDepth.vertex+ELLIPSOID_SHAPE",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 15612, bytes: 5472 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "6ed61e36efd13d28364a419c921e9dd1d9a2e609ba2a3e0e1d104f9c9669798e",
};
