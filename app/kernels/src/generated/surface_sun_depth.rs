// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/sun_depth.hlsl.
//! Kernels of `surface/sun_depth.hlsl`.

use super::{Ellipsoid, FrameLight, ListHead, Position, ShapeKeyword, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawSunDepth`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawSunDepthVariant {
    /// Keyword `SPRAY_SHAPE` or `ELLIPSOID_SHAPE`.
    pub shape: ShapeKeyword,
}

/// The surface that sunlight meets: the nearest of all particles' spheres, or ellipsoids, in the sun's
/// parallel projection, as shadow depth (1 nearest the sun), in which planes are linear; 0 where no
/// fluid is. At the walls they are cut off, as the eye sees them (surface/fluid\_depth.hlsl). Drops of
/// spray are left out: the map is too coarse for such lenses, which would tear holes into the light below.
#[derive(Debug)]
pub struct DrawSunDepth<'a> {
    /// Its variant.
    pub variant: DrawSunDepthVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Option<Buf<'a, Position>>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Option<Buf<'a, ListHead>>,
    /// `StructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: Option<Buf<'a, Ellipsoid>>,
}

impl Draw for DrawSunDepth<'_> {
    const STAGE: &'static str = "draw_sun_depth";

    fn vertex(&self) -> &'static Module {
        match self.variant.shape {
            ShapeKeyword::Off => &DRAW_SUN_DEPTH_VERTEX,
            ShapeKeyword::SprayShape => &DRAW_SUN_DEPTH_VERTEX_WITH_SPRAY_SHAPE,
            ShapeKeyword::EllipsoidShape => &DRAW_SUN_DEPTH_VERTEX_WITH_ELLIPSOID_SHAPE,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.shape {
            ShapeKeyword::Off => Some(&DRAW_SUN_DEPTH_FRAGMENT),
            ShapeKeyword::SprayShape => Some(&DRAW_SUN_DEPTH_FRAGMENT_WITH_SPRAY_SHAPE),
            ShapeKeyword::EllipsoidShape => Some(&DRAW_SUN_DEPTH_FRAGMENT),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("positions", self.positions.as_ref().map(|bound| bound.id)),
                ("light", Some(self.light.id)),
                ("surface", Some(self.surface.id)),
                ("list_heads", self.list_heads.as_ref().map(|bound| bound.id)),
                ("ellipsoids", self.ellipsoids.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_SUN_DEPTH_VERTEX,
    &DRAW_SUN_DEPTH_FRAGMENT,
    &DRAW_SUN_DEPTH_VERTEX_WITH_SPRAY_SHAPE,
    &DRAW_SUN_DEPTH_FRAGMENT_WITH_SPRAY_SHAPE,
    &DRAW_SUN_DEPTH_VERTEX_WITH_ELLIPSOID_SHAPE,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "list_heads", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "ellipsoids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_sun_depth.deflate"));

static DRAW_SUN_DEPTH_VERTEX: Module = Module {
    name: "DrawSunDepth.vertex",
    entry: "SunDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4316 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_depth.hlsl",
    hash: "31d29e3d535663b8b783fe72d3ffd3674ed16465d2d3b82cecd2449830bad399",
};

static DRAW_SUN_DEPTH_FRAGMENT: Module = Module {
    name: "DrawSunDepth.fragment",
    entry: "SunDepthFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4316, bytes: 3260 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_depth.hlsl",
    hash: "9be4f48ea9e67ea0ae85fa3cebf91e63711184696e635e85793fa7fa5c1160d8",
};

static DRAW_SUN_DEPTH_VERTEX_WITH_SPRAY_SHAPE: Module = Module {
    name: "DrawSunDepth.vertex+SPRAY_SHAPE",
    entry: "SunDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 7576, bytes: 4964 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_depth.hlsl",
    hash: "8ea6994104dffc98c5eae922775a98043e4fc5352660bd7dcb3de612a6c6d5b6",
};

static DRAW_SUN_DEPTH_FRAGMENT_WITH_SPRAY_SHAPE: Module = Module {
    name: "DrawSunDepth.fragment+SPRAY_SHAPE",
    entry: "SunDepthFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 12540, bytes: 3260 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_depth.hlsl",
    hash: "b469b2043efa7b26a31bb9a144baae2a6d9272fa91bdd2c3bc3844f2dc889c93",
};

static DRAW_SUN_DEPTH_VERTEX_WITH_ELLIPSOID_SHAPE: Module = Module {
    name: "DrawSunDepth.vertex+ELLIPSOID_SHAPE",
    entry: "SunDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 15800, bytes: 5400 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sun_depth.hlsl",
    hash: "2726479e1f047c6d2c39a4438b842925cd89ec359853eacf0eec80776fd24b22",
};
