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
    hash: "6408644efaf975ad42c9bec5c01b7f70d08c9eb879b540b8225492b791b9c9c2",
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
    hash: "d1b71103733fea8f90572425b3c93e8bc980816f0efa2a9c32f04f3f125a11ee",
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
    hash: "d3b9668c554eb73c8e32e918272992a4ac1aa4bbac512ccac283e02a65155e6b",
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
    hash: "6270daccbf3f09043df46f7e23171a644edf8f178f7e58d9400093d341894dd6",
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
    hash: "1a910acb84636e3cd700256786f4506eebbf792898353a1a27987b5612775860",
};
