// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/mark_blocks.compute.
//! Kernels of `surface/mesh/mark_blocks.compute`.

use super::MeshParams;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which blocks the surface may cross, from how many particles there are in and around each: those near some, but for
/// those that are full all around. A block is listed if it is such a one, or if one above it along some axes is: its
/// cells end at that one's points.
#[derive(Debug)]
pub struct MarkBlocks<'a> {
    /// `StructuredBuffer<uint> bin_starts`.
    pub bin_starts: Buf<'a, u32>,
    /// 1 or 0, to be scanned
    ///
    /// `RWStructuredBuffer<uint> block_listed`.
    pub block_listed: BufMut<'a, u32>,
    /// BLOCK\_OUTSIDE or BLOCK\_INSIDE, BLOCK\_LISTED where the field is to be made
    ///
    /// `RWStructuredBuffer<uint> block_entries`.
    pub block_entries: BufMut<'a, u32>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for MarkBlocks<'_> {
    const STAGE: &'static str = "mark_blocks";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MARK_BLOCKS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("bin_starts", Some(self.bin_starts.id)),
                ("block_listed", Some(self.block_listed.id)),
                ("block_entries", Some(self.block_entries.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MARK_BLOCKS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "bin_starts", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "block_listed",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "block_entries",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "mesh", slot: 3, kind: BindingKind::Uniform { bytes: 96 } },
];

static MARK_BLOCKS: Module = Module {
    name: "MarkBlocks",
    entry: "MarkBlocks",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/mark_blocks.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mark_blocks.compute",
    hash: "94f04151ee7837d695666abb8e12a2187c7cfb90afc53835b9c53891db888feb",
};
