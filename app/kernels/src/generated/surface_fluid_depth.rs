// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/fluid_depth.hlsl.
//! Kernels of `surface/fluid_depth.hlsl`.

use super::{Ellipsoid, FrameView, ListHead, Position, ShapeKeyword, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tier, Uniform, bind_draw,
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

static DRAW_FLUID_DEPTH_VERTEX: Module = Module {
    name: "DrawFluidDepth.vertex",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "c2e5f08b0201617c3035e826a95124250bfc5d602cd950088a274c37371370b3",
};

static DRAW_FLUID_DEPTH_FRAGMENT: Module = Module {
    name: "DrawFluidDepth.fragment",
    entry: "FluidDepthFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "c9c68ad26939adfd6466f46c6e143a388243891982f58b86ae5f9e7af4b7cbf8",
};

static DRAW_FLUID_DEPTH_VERTEX_WITH_SPRAY_SHAPE: Module = Module {
    name: "DrawFluidDepth.vertex+SPRAY_SHAPE",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.vertex+spray_shape.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "b249bff0d39c8af5691a2c199e6bf9772c11c83f107b49981a202e23a8d78947",
};

static DRAW_FLUID_DEPTH_FRAGMENT_WITH_SPRAY_SHAPE: Module = Module {
    name: "DrawFluidDepth.fragment+SPRAY_SHAPE",
    entry: "FluidDepthFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.fragment+spray_shape.spv"),
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "1b88e7c86c9106ae41e3a9dbfccf88dfda032364e84f2996e56edcf3088c3537",
};

static DRAW_FLUID_DEPTH_VERTEX_WITH_ELLIPSOID_SHAPE: Module = Module {
    name: "DrawFluidDepth.vertex+ELLIPSOID_SHAPE",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.vertex+ellipsoid_shape.spv"),
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "e522e6842201c43343b5fabc438398e5f4ddf2517d50d3fb9a88a476d03cd5eb",
};
