// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/emit_triangles.compute.
//! Kernels of `surface/mesh/emit_triangles.compute`.

use super::{MeshCounts, MeshParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The surface's triangles, as numbers of vertices. One that has no place, or a vertex that has none, is left out and
/// counted; nothing is written beyond a buffer's end.
#[derive(Debug)]
pub struct EmitTriangles<'a> {
    /// `StructuredBuffer<uint2> block_inside`.
    pub block_inside: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> block_entries`.
    pub block_entries: Buf<'a, u32>,
    /// `StructuredBuffer<uint> listed_blocks`.
    pub listed_blocks: Buf<'a, u32>,
    /// `StructuredBuffer<uint2> triangle_table`.
    pub triangle_table: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> triangle_starts`.
    pub triangle_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> point_vertices`.
    pub point_vertices: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> mesh_indices`.
    pub mesh_indices: BufMut<'a, u32>,
    /// `RWStructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: BufMut<'a, MeshCounts>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for EmitTriangles<'_> {
    const STAGE: &'static str = "emit_triangles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &EMIT_TRIANGLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("block_inside", Some(self.block_inside.id)),
                ("block_entries", Some(self.block_entries.id)),
                ("listed_blocks", Some(self.listed_blocks.id)),
                ("triangle_table", Some(self.triangle_table.id)),
                ("triangle_starts", Some(self.triangle_starts.id)),
                ("point_vertices", Some(self.point_vertices.id)),
                ("mesh_indices", Some(self.mesh_indices.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&EMIT_TRIANGLES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "block_inside", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "block_entries",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "listed_blocks",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "triangle_table",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "triangle_starts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "point_vertices",
        slot: 5,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "mesh_indices",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "mesh_counts",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo { name: "mesh", slot: 8, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_emit_triangles.deflate"));

static EMIT_TRIANGLES: Module = Module {
    name: "EmitTriangles",
    entry: "EmitTriangles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 18140 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 112,
    tier: Tier::Floor,
    source: "surface/mesh/emit_triangles.compute",
    hash: "e9c049926e4b0dab3caf7e1e783fa31a1220d090a2c77a686ac51d396ce0d38d",
};
