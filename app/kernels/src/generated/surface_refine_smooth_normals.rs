// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/smooth_normals.compute.
//! Kernels of `surface/refine/smooth_normals.compute`.

use super::{MeshSize, MeshVertex, RefineParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Normals, each the mean of its own and those of its vertex's ring, weighted by distance and by how little they differ
/// (bilateral: Tomasi & Manduchi 1998, on normals as Jones, Durand & Zwicker 2004). Twin: reference/src/surface/smooth\_normals.rs.
#[derive(Debug)]
pub struct SmoothNormals<'a> {
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `StructuredBuffer<uint> ring_starts`.
    pub ring_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> rings`.
    pub rings: Buf<'a, u32>,
    /// `StructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: Buf<'a, MeshVertex>,
    /// `RWStructuredBuffer<MeshVertex> smoothed_vertices`.
    pub smoothed_vertices: BufMut<'a, MeshVertex>,
    /// `ConstantBuffer<RefineParams> refine`.
    pub refine: Uniform<'a, RefineParams>,
}

impl Kernel for SmoothNormals<'_> {
    const STAGE: &'static str = "smooth_normals";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SMOOTH_NORMALS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_size", Some(self.mesh_size.id)),
                ("ring_starts", Some(self.ring_starts.id)),
                ("rings", Some(self.rings.id)),
                ("mesh_vertices", Some(self.mesh_vertices.id)),
                ("smoothed_vertices", Some(self.smoothed_vertices.id)),
                ("refine", Some(self.refine.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SMOOTH_NORMALS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_size", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "ring_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "rings", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "mesh_vertices",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo {
        name: "smoothed_vertices",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "refine", slot: 5, kind: BindingKind::Uniform { bytes: 24 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_smooth_normals.deflate"));

static SMOOTH_NORMALS: Module = Module {
    name: "SmoothNormals",
    entry: "SmoothNormals",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3780 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/smooth_normals.compute",
    hash: "17ea98f28756909aec114f846516a12b33728e475e0ce5f00a73c79a62409570",
};
