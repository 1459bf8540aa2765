// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/mark_blocks.compute.
//! Kernels of `surface/mesh/mark_blocks.compute`.

use super::MeshParams;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which blocks the surface may cross, from how many particles there are in the bins around each: those near some, but
/// for those that are full all around. A block is listed if it is such a one, or if the first points of those above it,
/// where its cells end, are not all as its own: at a wall, what is full ends without a field in between.
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
    /// a bit for each point; of a listed block GatherField says it
    ///
    /// `RWStructuredBuffer<uint2> block_inside`.
    pub block_inside: BufMut<'a, [u32; 2]>,
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
                ("block_inside", Some(self.block_inside.id)),
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
    BindingInfo {
        name: "block_inside",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "mesh", slot: 4, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_mark_blocks.deflate"));

static MARK_BLOCKS: Module = Module {
    name: "MarkBlocks",
    entry: "MarkBlocks",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 9600 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 500,
    tier: Tier::Floor,
    source: "surface/mesh/mark_blocks.compute",
    hash: "1d0866ec34ede1b27130ecad9168ae2756adb7caad701218cdbd90b1ea9f17f1",
};
