// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/subdivide_middles.compute.
//! Kernels of `surface/refine/subdivide_middles.compute`.

use super::{MeshSize, MeshVertex, RefineParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The vertex within each triangle whose sides are cut into three parts.
#[derive(Debug)]
pub struct SubdivideMiddles<'a> {
    /// `StructuredBuffer<uint> mesh_indices`.
    pub mesh_indices: Buf<'a, u32>,
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `StructuredBuffer<uint> edge_starts`.
    pub edge_starts: Buf<'a, u32>,
    /// `StructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: Buf<'a, MeshVertex>,
    /// `RWStructuredBuffer<MeshVertex> fine_vertices`.
    pub fine_vertices: BufMut<'a, MeshVertex>,
    /// `ConstantBuffer<RefineParams> refine`.
    pub refine: Uniform<'a, RefineParams>,
}

impl Kernel for SubdivideMiddles<'_> {
    const STAGE: &'static str = "subdivide_middles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SUBDIVIDE_MIDDLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_indices", Some(self.mesh_indices.id)),
                ("mesh_size", Some(self.mesh_size.id)),
                ("edge_starts", Some(self.edge_starts.id)),
                ("mesh_vertices", Some(self.mesh_vertices.id)),
                ("fine_vertices", Some(self.fine_vertices.id)),
                ("refine", Some(self.refine.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SUBDIVIDE_MIDDLES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_indices", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "mesh_size", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "edge_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "mesh_vertices",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo {
        name: "fine_vertices",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "refine", slot: 5, kind: BindingKind::Uniform { bytes: 24 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_subdivide_middles.deflate"));

static SUBDIVIDE_MIDDLES: Module = Module {
    name: "SubdivideMiddles",
    entry: "SubdivideMiddles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 6296 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/subdivide_middles.compute",
    hash: "e971fc306232ca2af22249d7c46808702af68170805abfb55dd7c9dd1a968505",
};
