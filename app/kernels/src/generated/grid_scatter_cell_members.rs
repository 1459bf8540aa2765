// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/scatter_cell_members.compute.
//! Kernels of `grid/scatter_cell_members.compute`.

use super::{CellSlot, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// First pass of the deterministic order: which particles each cell holds, in whatever order the
/// atomics of CountCells gave.
#[derive(Debug)]
pub struct ScatterCellMembers<'a> {
    /// `StructuredBuffer<CellSlot> cell_slots`.
    pub cell_slots: Buf<'a, CellSlot>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> cell_members`.
    pub cell_members: BufMut<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for ScatterCellMembers<'_> {
    const STAGE: &'static str = "scatter_cell_members";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SCATTER_CELL_MEMBERS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("cell_slots", Some(self.cell_slots.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("cell_members", Some(self.cell_members.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SCATTER_CELL_MEMBERS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "cell_slots", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "cell_members",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_scatter_cell_members.deflate"));

static SCATTER_CELL_MEMBERS: Module = Module {
    name: "ScatterCellMembers",
    entry: "ScatterCellMembers",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2288 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/scatter_cell_members.compute",
    hash: "93539b2fed55c7ccb7d059e608b2f14b693d51612dd3ea33f0658a3af9e9671b",
};
