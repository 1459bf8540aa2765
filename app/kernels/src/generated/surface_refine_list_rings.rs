// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/list_rings.compute.
//! Kernels of `surface/refine/list_rings.compute`.

use super::MeshSize;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// The ends of each vertex's sides, side by side.
#[derive(Debug)]
pub struct ListRings<'a> {
    /// `StructuredBuffer<uint> mesh_indices`.
    pub mesh_indices: Buf<'a, u32>,
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `StructuredBuffer<uint> ring_starts`.
    pub ring_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> ring_places`.
    pub ring_places: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> rings`.
    pub rings: BufMut<'a, u32>,
}

impl Kernel for ListRings<'_> {
    const STAGE: &'static str = "list_rings";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &LIST_RINGS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_indices", Some(self.mesh_indices.id)),
                ("mesh_size", Some(self.mesh_size.id)),
                ("ring_starts", Some(self.ring_starts.id)),
                ("ring_places", Some(self.ring_places.id)),
                ("rings", Some(self.rings.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&LIST_RINGS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_indices", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "mesh_size", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "ring_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "ring_places", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "rings", slot: 4, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_list_rings.deflate"));

static LIST_RINGS: Module = Module {
    name: "ListRings",
    entry: "ListRings",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2472 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/list_rings.compute",
    hash: "864923ead9b564fb0050bd4eeb0f5847c2b0e443f77f2a58a011351d4b0d5e90",
};
