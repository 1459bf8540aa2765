// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/subdivide_triangles.compute.
//! Kernels of `surface/refine/subdivide_triangles.compute`.

use super::{MeshCounts, MeshSize, RefineParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The subdivided mesh's triangles. One that has no place, or a vertex that has none, is left out and counted; nothing is
/// written beyond a buffer's end.
#[derive(Debug)]
pub struct SubdivideTriangles<'a> {
    /// `StructuredBuffer<uint> mesh_indices`.
    pub mesh_indices: Buf<'a, u32>,
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `StructuredBuffer<uint> ring_starts`.
    pub ring_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> rings`.
    pub rings: Buf<'a, u32>,
    /// `StructuredBuffer<uint> edge_starts`.
    pub edge_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> fine_indices`.
    pub fine_indices: BufMut<'a, u32>,
    /// `RWStructuredBuffer<MeshCounts> fine_counts`.
    pub fine_counts: BufMut<'a, MeshCounts>,
    /// `ConstantBuffer<RefineParams> refine`.
    pub refine: Uniform<'a, RefineParams>,
}

impl Kernel for SubdivideTriangles<'_> {
    const STAGE: &'static str = "subdivide_triangles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SUBDIVIDE_TRIANGLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_indices", Some(self.mesh_indices.id)),
                ("mesh_size", Some(self.mesh_size.id)),
                ("ring_starts", Some(self.ring_starts.id)),
                ("rings", Some(self.rings.id)),
                ("edge_starts", Some(self.edge_starts.id)),
                ("fine_indices", Some(self.fine_indices.id)),
                ("fine_counts", Some(self.fine_counts.id)),
                ("refine", Some(self.refine.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SUBDIVIDE_TRIANGLES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_indices", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "mesh_size", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "ring_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "rings", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "edge_starts", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "fine_indices",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "fine_counts",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo { name: "refine", slot: 7, kind: BindingKind::Uniform { bytes: 24 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_subdivide_triangles.deflate"));

static SUBDIVIDE_TRIANGLES: Module = Module {
    name: "SubdivideTriangles",
    entry: "SubdivideTriangles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 12972 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/subdivide_triangles.compute",
    hash: "de1f008e5b29665ede83d41f56fd3952d8780d47cb8b16f048ab0344576e6aba",
};
