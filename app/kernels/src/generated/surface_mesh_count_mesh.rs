// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/count_mesh.compute.
//! Kernels of `surface/mesh/count_mesh.compute`.

use super::{MeshCounts, MeshParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// How many vertices and triangles each listed block has.
#[derive(Debug)]
pub struct CountMesh<'a> {
    /// `StructuredBuffer<uint2> block_inside`.
    pub block_inside: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> listed_blocks`.
    pub listed_blocks: Buf<'a, u32>,
    /// `StructuredBuffer<uint2> triangle_table`.
    pub triangle_table: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// `RWStructuredBuffer<uint> vertex_counts`.
    pub vertex_counts: BufMut<'a, u32>,
    /// `RWStructuredBuffer<uint> triangle_counts`.
    pub triangle_counts: BufMut<'a, u32>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for CountMesh<'_> {
    const STAGE: &'static str = "count_mesh";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COUNT_MESH
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("block_inside", Some(self.block_inside.id)),
                ("listed_blocks", Some(self.listed_blocks.id)),
                ("triangle_table", Some(self.triangle_table.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("vertex_counts", Some(self.vertex_counts.id)),
                ("triangle_counts", Some(self.triangle_counts.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COUNT_MESH];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "block_inside", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "listed_blocks",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "triangle_table",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "mesh_counts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo {
        name: "vertex_counts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "triangle_counts",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "mesh", slot: 6, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_count_mesh.deflate"));

static COUNT_MESH: Module = Module {
    name: "CountMesh",
    entry: "CountMesh",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 14516 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 112,
    tier: Tier::Floor,
    source: "surface/mesh/count_mesh.compute",
    hash: "0d3978e4e6e24d9f09e8afe9ce015784f4bd10b4b07cea2045c23fced7e10c42",
};
