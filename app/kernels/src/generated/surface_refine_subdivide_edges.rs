// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/subdivide_edges.compute.
//! Kernels of `surface/refine/subdivide_edges.compute`.

use super::{MeshSize, MeshVertex, RefineParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The subdivided mesh's vertices but for those within triangles: each vertex as it is, and those on the edges to vertices
/// of a higher number, from itself on. One thread makes what both triangles at an edge share.
#[derive(Debug)]
pub struct SubdivideEdges<'a> {
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `StructuredBuffer<uint> ring_starts`.
    pub ring_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> rings`.
    pub rings: Buf<'a, u32>,
    /// `StructuredBuffer<uint> edge_starts`.
    pub edge_starts: Buf<'a, u32>,
    /// `StructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: Buf<'a, MeshVertex>,
    /// `RWStructuredBuffer<MeshVertex> fine_vertices`.
    pub fine_vertices: BufMut<'a, MeshVertex>,
    /// `ConstantBuffer<RefineParams> refine`.
    pub refine: Uniform<'a, RefineParams>,
}

impl Kernel for SubdivideEdges<'_> {
    const STAGE: &'static str = "subdivide_edges";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SUBDIVIDE_EDGES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_size", Some(self.mesh_size.id)),
                ("ring_starts", Some(self.ring_starts.id)),
                ("rings", Some(self.rings.id)),
                ("edge_starts", Some(self.edge_starts.id)),
                ("mesh_vertices", Some(self.mesh_vertices.id)),
                ("fine_vertices", Some(self.fine_vertices.id)),
                ("refine", Some(self.refine.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SUBDIVIDE_EDGES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_size", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "ring_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "rings", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "edge_starts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "mesh_vertices",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo {
        name: "fine_vertices",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "refine", slot: 6, kind: BindingKind::Uniform { bytes: 24 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_subdivide_edges.deflate"));

static SUBDIVIDE_EDGES: Module = Module {
    name: "SubdivideEdges",
    entry: "SubdivideEdges",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5368 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/subdivide_edges.compute",
    hash: "8fc93726c2b1e1dbb4ad6230dd5e437e79a216908a3017969bc64a669b1aad72",
};
