// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/count_edges.compute.
//! Kernels of `surface/refine/count_edges.compute`.

use super::MeshSize;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// How many edges each vertex has to vertices of a higher number: each edge is that of its lower end.
#[derive(Debug)]
pub struct CountEdges<'a> {
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `StructuredBuffer<uint> ring_starts`.
    pub ring_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> rings`.
    pub rings: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> edge_counts`.
    pub edge_counts: BufMut<'a, u32>,
}

impl Kernel for CountEdges<'_> {
    const STAGE: &'static str = "count_edges";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COUNT_EDGES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_size", Some(self.mesh_size.id)),
                ("ring_starts", Some(self.ring_starts.id)),
                ("rings", Some(self.rings.id)),
                ("edge_counts", Some(self.edge_counts.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COUNT_EDGES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_size", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "ring_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "rings", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "edge_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_count_edges.deflate"));

static COUNT_EDGES: Module = Module {
    name: "CountEdges",
    entry: "CountEdges",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2052 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/count_edges.compute",
    hash: "4db3ddfce9bd8b6a35a2125ab8b79275df30d1a0734e333ae58fa1da20a2824c",
};
