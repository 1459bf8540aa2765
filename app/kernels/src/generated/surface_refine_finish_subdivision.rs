// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/finish_subdivision.compute.
//! Kernels of `surface/refine/finish_subdivision.compute`.

use super::{MeshCounts, RefineParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// What the subdivided mesh comes to, as a draw reads it: what was lost before it counts as its triangles do.
#[derive(Debug)]
pub struct FinishSubdivision<'a> {
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// of every place for a vertex and one more, which ends them
    ///
    /// `StructuredBuffer<uint> edge_starts`.
    pub edge_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<MeshCounts> fine_counts`.
    pub fine_counts: BufMut<'a, MeshCounts>,
    /// `ConstantBuffer<RefineParams> refine`.
    pub refine: Uniform<'a, RefineParams>,
}

impl Kernel for FinishSubdivision<'_> {
    const STAGE: &'static str = "finish_subdivision";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &FINISH_SUBDIVISION
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("edge_starts", Some(self.edge_starts.id)),
                ("fine_counts", Some(self.fine_counts.id)),
                ("refine", Some(self.refine.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&FINISH_SUBDIVISION];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_counts", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo { name: "edge_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "fine_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo { name: "refine", slot: 3, kind: BindingKind::Uniform { bytes: 24 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_finish_subdivision.deflate"));

static FINISH_SUBDIVISION: Module = Module {
    name: "FinishSubdivision",
    entry: "FinishSubdivision",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3168 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/finish_subdivision.compute",
    hash: "b503c1f8e5c4ce742502c84020cb8724f2b5a2860155de20827614c80d9b9104",
};
