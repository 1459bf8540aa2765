// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/rank_by_id.compute.
//! Kernels of `grid/rank_by_id.compute`.

use super::{CellSlot, GridParams, Position, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Second pass of the deterministic order: a particle's rank in its cell becomes the number of the
/// cell's particles with a lower id. Every sum over neighbours then runs in the same order in every
/// run, and for every order of the input. Cells of h/2 hold a few particles, so each looks at few;
/// the cell of what lies outside may hold many, is nobody's neighbour, and keeps its order. So does a cell
/// of more than MAX\_CANDIDATES: a search does not look at all of it either, and counts that. Inactive slots are
/// ranked as well: they are activated in their order.
#[derive(Debug)]
pub struct RankById<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> cell_members`.
    pub cell_members: Buf<'a, u32>,
    /// `RWStructuredBuffer<CellSlot> cell_slots`.
    pub cell_slots: BufMut<'a, CellSlot>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
}

impl Kernel for RankById<'_> {
    const STAGE: &'static str = "rank_by_id";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &RANK_BY_ID
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("cell_members", Some(self.cell_members.id)),
                ("cell_slots", Some(self.cell_slots.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&RANK_BY_ID];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "cell_members", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "cell_slots",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 5, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_rank_by_id.deflate"));

static RANK_BY_ID: Module = Module {
    name: "RankById",
    entry: "RankById",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3848 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/rank_by_id.compute",
    hash: "fea5f62edb6d6840530ed44a4008254a8a6d56dbaef006070eaf7a066cd85abc",
};
