// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/mesh_normals.compute.
//! Kernels of `surface/mesh/mesh_normals.compute`.

use super::{MeshCounts, MeshParams, MeshVertex, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// The normal of each vertex that no wall gave one: the field's gradient where the vertex is, turned outward. There are an
/// eighth as many vertices as points of the field, so it is asked here and not there.
#[derive(Debug)]
pub struct MeshNormals<'a> {
    /// `StructuredBuffer<Position> bin_particles`.
    pub bin_particles: Buf<'a, Position>,
    /// `StructuredBuffer<uint> bin_starts`.
    pub bin_starts: Buf<'a, u32>,
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// `RWStructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: BufMut<'a, MeshVertex>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for MeshNormals<'_> {
    const STAGE: &'static str = "mesh_normals";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MESH_NORMALS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("bin_particles", Some(self.bin_particles.id)),
                ("bin_starts", Some(self.bin_starts.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("mesh_vertices", Some(self.mesh_vertices.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MESH_NORMALS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "bin_particles",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "mesh_counts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo {
        name: "mesh_vertices",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "mesh", slot: 4, kind: BindingKind::Uniform { bytes: 160 } },
];

static MESH_NORMALS: Module = Module {
    name: "MeshNormals",
    entry: "MeshNormals",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/mesh_normals.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mesh_normals.compute",
    hash: "9919bd939bca152770192cd637f49f4c69e81e91faf7373ca024d3eef1779513",
};
