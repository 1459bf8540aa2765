// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/emit_vertices.compute.
//! Kernels of `surface/mesh/emit_vertices.compute`.

use super::{MeshCounts, MeshParams, MeshVertex};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The surface's vertices, each where the field is 0 along an edge from its thread's point. At a wall that is the wall's own
/// point, which has its normal from the wall; the others get theirs from MeshNormals.
#[derive(Debug)]
pub struct EmitVertices<'a> {
    /// `StructuredBuffer<float> field_m`.
    pub field_m: Buf<'a, f32>,
    /// `StructuredBuffer<uint2> block_inside`.
    pub block_inside: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> block_entries`.
    pub block_entries: Buf<'a, u32>,
    /// `StructuredBuffer<uint> listed_blocks`.
    pub listed_blocks: Buf<'a, u32>,
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// `StructuredBuffer<uint> vertex_starts`.
    pub vertex_starts: Buf<'a, u32>,
    /// a point's first vertex, and in the top three bits along which axes it has one
    ///
    /// `RWStructuredBuffer<uint> point_vertices`.
    pub point_vertices: BufMut<'a, u32>,
    /// `RWStructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: BufMut<'a, MeshVertex>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for EmitVertices<'_> {
    const STAGE: &'static str = "emit_vertices";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &EMIT_VERTICES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("field_m", Some(self.field_m.id)),
                ("block_inside", Some(self.block_inside.id)),
                ("block_entries", Some(self.block_entries.id)),
                ("listed_blocks", Some(self.listed_blocks.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("vertex_starts", Some(self.vertex_starts.id)),
                ("point_vertices", Some(self.point_vertices.id)),
                ("mesh_vertices", Some(self.mesh_vertices.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&EMIT_VERTICES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "field_m", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "block_inside", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "block_entries",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "listed_blocks",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "mesh_counts", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo {
        name: "vertex_starts",
        slot: 5,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "point_vertices",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "mesh_vertices",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "mesh", slot: 8, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_emit_vertices.deflate"));

static EMIT_VERTICES: Module = Module {
    name: "EmitVertices",
    entry: "EmitVertices",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 16116 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 112,
    tier: Tier::Floor,
    source: "surface/mesh/emit_vertices.compute",
    hash: "13173b56a837b09ef641d53f820046d3e6b6e3fa4a13f13b708712396e4b9f5b",
};
