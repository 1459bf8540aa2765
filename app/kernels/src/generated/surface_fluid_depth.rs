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
    hash: "5be386c4c8bc34d19e7fc64ee85425a5353b3a728002d028a64ce3396b130417",
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
    hash: "98dca8b8ab9218bfdea4d46c9f21f974c02b8c11387603c3e0baedeb97b0285c",
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
    hash: "f94e2735e89943936757656fc8c9e2db1e536978c8a24132fd63677bef70dc75",
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
    hash: "c9f45f27bcca029f54370c261916ac330faa6b4985ece0dc74782ed5da2b6c69",
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
    hash: "52c7a90ae496d60c1e0f48c60d25365983a0a49784aae7bece9961da3a399f91",
};
