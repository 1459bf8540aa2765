// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/size_mesh.compute.
//! Kernels of `surface/refine/size_mesh.compute`.

use super::{MeshCounts, MeshSize};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// How many groups the stages take that have a thread for each of a mesh's vertices, or triangles.
#[derive(Debug)]
pub struct SizeMesh<'a> {
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// `RWStructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: BufMut<'a, MeshSize>,
}

impl Kernel for SizeMesh<'_> {
    const STAGE: &'static str = "size_mesh";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &SIZE_MESH
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(self.module(), &[("mesh_counts", Some(self.mesh_counts.id)), ("mesh_size", Some(self.mesh_size.id))])
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SIZE_MESH];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_counts", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo {
        name: "mesh_size",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_size_mesh.deflate"));

static SIZE_MESH: Module = Module {
    name: "SizeMesh",
    entry: "SizeMesh",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2212 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/size_mesh.compute",
    hash: "f3cc11f299c58e207ac5497f3047c6fa2b743aa577576eb2c879d1ea5419b075",
};
