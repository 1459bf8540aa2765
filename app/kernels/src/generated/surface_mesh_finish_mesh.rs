// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/finish_mesh.compute.
//! Kernels of `surface/mesh/finish_mesh.compute`.

use super::{MeshCounts, MeshParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// What the mesh came to, as a draw and later dispatches read it.
#[derive(Debug)]
pub struct FinishMesh<'a> {
    /// of every place in the list and one more, which ends them
    ///
    /// `StructuredBuffer<uint> vertex_starts`.
    pub vertex_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> triangle_starts`.
    pub triangle_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: BufMut<'a, MeshCounts>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for FinishMesh<'_> {
    const STAGE: &'static str = "finish_mesh";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &FINISH_MESH
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("vertex_starts", Some(self.vertex_starts.id)),
                ("triangle_starts", Some(self.triangle_starts.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&FINISH_MESH];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "vertex_starts",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "triangle_starts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "mesh_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo { name: "mesh", slot: 3, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_finish_mesh.deflate"));

static FINISH_MESH: Module = Module {
    name: "FinishMesh",
    entry: "FinishMesh",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3580 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/finish_mesh.compute",
    hash: "5aaa0fca4f712f7e456ad0481a37904a54401ed4a958b01300f72ea4174047ce",
};
