// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/sort_rings.compute.
//! Kernels of `surface/refine/sort_rings.compute`.

use super::MeshSize;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// Each vertex's ring, ascending: in the same order in every run, whichever of its triangles came first. A ring has 6
/// vertices on average, so they are put in one by one.
#[derive(Debug)]
pub struct SortRings<'a> {
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `StructuredBuffer<uint> ring_starts`.
    pub ring_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> rings`.
    pub rings: BufMut<'a, u32>,
}

impl Kernel for SortRings<'_> {
    const STAGE: &'static str = "sort_rings";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SORT_RINGS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_size", Some(self.mesh_size.id)),
                ("ring_starts", Some(self.ring_starts.id)),
                ("rings", Some(self.rings.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SORT_RINGS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_size", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "ring_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "rings", slot: 2, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_sort_rings.deflate"));

static SORT_RINGS: Module = Module {
    name: "SortRings",
    entry: "SortRings",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2232 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/sort_rings.compute",
    hash: "66212404ad7919132df0b64355e18927eacd86478f15c3184d44f04dc41c0a49",
};
