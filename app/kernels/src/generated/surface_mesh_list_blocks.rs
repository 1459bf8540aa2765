// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/list_blocks.compute.
//! Kernels of `surface/mesh/list_blocks.compute`.

use super::{MeshCounts, MeshParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The listed blocks side by side, and where each of the grid's blocks is among them.
#[derive(Debug)]
pub struct ListBlocks<'a> {
    /// `StructuredBuffer<uint> block_listed`.
    pub block_listed: Buf<'a, u32>,
    /// `StructuredBuffer<uint> block_starts`.
    pub block_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> block_entries`.
    pub block_entries: BufMut<'a, u32>,
    /// with BLOCK\_UNIFORM and BLOCK\_UNIFORM\_INSIDE
    ///
    /// `RWStructuredBuffer<uint> listed_blocks`.
    pub listed_blocks: BufMut<'a, u32>,
    /// `RWStructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: BufMut<'a, MeshCounts>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for ListBlocks<'_> {
    const STAGE: &'static str = "list_blocks";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &LIST_BLOCKS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("block_listed", Some(self.block_listed.id)),
                ("block_starts", Some(self.block_starts.id)),
                ("block_entries", Some(self.block_entries.id)),
                ("listed_blocks", Some(self.listed_blocks.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&LIST_BLOCKS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "block_listed", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "block_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "block_entries",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "listed_blocks",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "mesh_counts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo { name: "mesh", slot: 5, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_list_blocks.deflate"));

static LIST_BLOCKS: Module = Module {
    name: "ListBlocks",
    entry: "ListBlocks",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4636 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/list_blocks.compute",
    hash: "1c94aa0ec4002c814079cd494f6302eb1813416882487f07c3a6bccf744c3be6",
};
