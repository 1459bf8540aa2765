// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/anisotropy.compute.
//! Kernels of `surface/anisotropy.compute`.

use super::{AnisotropyParams, Ellipsoid, ListHead, Position, StepState, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Each particle's ellipsoid (Yu & Turk 2013): where its neighbours lie around it is wide, along a
/// surface, it is wide, and where they end it is thin. Lines of spheres then close into planes.
#[derive(Debug)]
pub struct Anisotropy<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: BufMut<'a, Ellipsoid>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<AnisotropyParams> anisotropy`.
    pub anisotropy: Uniform<'a, AnisotropyParams>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Kernel for Anisotropy<'_> {
    const STAGE: &'static str = "anisotropy";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &ANISOTROPY
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("ellipsoids", Some(self.ellipsoids.id)),
                ("step_state", Some(self.step_state.id)),
                ("anisotropy", Some(self.anisotropy.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&ANISOTROPY];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "ellipsoids",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "anisotropy", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "surface", slot: 6, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_anisotropy.deflate"));

static ANISOTROPY: Module = Module {
    name: "Anisotropy",
    entry: "Anisotropy",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 14052 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/anisotropy.compute",
    hash: "486cba4166f82df9653c99abe4cc86cf79a33147dd645cbe1ef75faae04218d5",
};
