// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refine/count_rings.compute.
//! Kernels of `surface/refine/count_rings.compute`.

use super::MeshSize;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// How many sides start at each vertex: on a closed mesh whose triangles are oriented alike, as many as it has
/// neighbours, each at the end of one of them. The atomic gives each side its place among them as well.
#[derive(Debug)]
pub struct CountRings<'a> {
    /// `StructuredBuffer<uint> mesh_indices`.
    pub mesh_indices: Buf<'a, u32>,
    /// `StructuredBuffer<MeshSize> mesh_size`.
    pub mesh_size: Buf<'a, MeshSize>,
    /// `RWStructuredBuffer<uint> ring_counts`.
    pub ring_counts: BufMut<'a, u32>,
    /// of each side of the triangles
    ///
    /// `RWStructuredBuffer<uint> ring_places`.
    pub ring_places: BufMut<'a, u32>,
}

impl Kernel for CountRings<'_> {
    const STAGE: &'static str = "count_rings";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COUNT_RINGS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("mesh_indices", Some(self.mesh_indices.id)),
                ("mesh_size", Some(self.mesh_size.id)),
                ("ring_counts", Some(self.ring_counts.id)),
                ("ring_places", Some(self.ring_places.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COUNT_RINGS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_indices", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "mesh_size", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo {
        name: "ring_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "ring_places",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refine_count_rings.deflate"));

static COUNT_RINGS: Module = Module {
    name: "CountRings",
    entry: "CountRings",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2304 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refine/count_rings.compute",
    hash: "e94d40372e3c205af5655357836c464bd5134de461fa04fa341b4a4fcf15270b",
};
