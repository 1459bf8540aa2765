// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/fluid_depth.hlsl.
//! Kernels of `surface/fluid_depth.hlsl`.

use super::{Ellipsoid, FrameView, ListHead, Position, SprayOrEllipsoidsKeyword, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawFluidDepth`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawFluidDepthVariant {
    /// Keyword `SPRAY` or `ELLIPSOIDS`.
    pub spray_or_ellipsoids: SprayOrEllipsoidsKeyword,
}

/// The nearest of all particles' spheres, or ellipsoids (surface/anisotropy.compute), in each pixel, as
/// nearness. At the tank's glass they are cut off: there the water is as flat as the glass.
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
    /// A particle far from all others is a drop of spray: drawn as large as one that has to meet its
    /// neighbours it would be a ball of glass.
    ///
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Option<Buf<'a, ListHead>>,
    /// `StructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: Option<Buf<'a, Ellipsoid>>,
}

impl Draw for DrawFluidDepth<'_> {
    const STAGE: &'static str = "draw_fluid_depth";

    fn vertex(&self) -> &'static Module {
        match self.variant.spray_or_ellipsoids {
            SprayOrEllipsoidsKeyword::Off => &DRAW_FLUID_DEPTH_VERTEX,
            SprayOrEllipsoidsKeyword::Spray => &DRAW_FLUID_DEPTH_VERTEX_WITH_SPRAY,
            SprayOrEllipsoidsKeyword::Ellipsoids => &DRAW_FLUID_DEPTH_VERTEX_WITH_ELLIPSOIDS,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match self.variant.spray_or_ellipsoids {
            SprayOrEllipsoidsKeyword::Off => Some(&DRAW_FLUID_DEPTH_FRAGMENT),
            SprayOrEllipsoidsKeyword::Spray => Some(&DRAW_FLUID_DEPTH_FRAGMENT_WITH_SPRAY),
            SprayOrEllipsoidsKeyword::Ellipsoids => Some(&DRAW_FLUID_DEPTH_FRAGMENT),
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
    &DRAW_FLUID_DEPTH_VERTEX_WITH_SPRAY,
    &DRAW_FLUID_DEPTH_FRAGMENT_WITH_SPRAY,
    &DRAW_FLUID_DEPTH_VERTEX_WITH_ELLIPSOIDS,
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
    hash: "5b7ce49882e5c872cff40aa82edae0cebde8cbd2b713514206e4b7a225085393",
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
    hash: "e8ce17f8be6d61a0a0b01a4362ec41424266c4982ee64ff2e25c7d25d5d3d66d",
};

static DRAW_FLUID_DEPTH_VERTEX_WITH_SPRAY: Module = Module {
    name: "DrawFluidDepth.vertex+SPRAY",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.vertex+spray.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "fb01cd35d856dbe97ec4f6db751088964e17c5ed3c538eb4d37ccdd440b9e464",
};

static DRAW_FLUID_DEPTH_FRAGMENT_WITH_SPRAY: Module = Module {
    name: "DrawFluidDepth.fragment+SPRAY",
    entry: "FluidDepthFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.fragment+spray.spv"),
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "c0f694152fc29cc2416766709ee4cced14141e4c21e84b681b95b0dd917d034d",
};

static DRAW_FLUID_DEPTH_VERTEX_WITH_ELLIPSOIDS: Module = Module {
    name: "DrawFluidDepth.vertex+ELLIPSOIDS",
    entry: "FluidDepthVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_fluid_depth.vertex+ellipsoids.spv"),
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/fluid_depth.hlsl",
    hash: "dace85a41ca9aef6a8675aeb6e06a10217adaac3dc8b659ce2b8492775e3dac2",
};
