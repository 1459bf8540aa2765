// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/rank_by_id.compute.
//! Kernels of `grid/rank_by_id.compute`.

use super::{CellSlot, GridParams, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Second pass of the deterministic order: a particle's rank in its cell becomes the number of the
/// cell's particles with a lower id. Every sum over neighbours then runs in the same order in every
/// run, and for every order of the input. Cells of h/2 hold a few particles, so each looks at few;
/// the cell of what lies outside may hold many, is nobody's neighbour, and keeps its order. So does a cell
/// of more than MAX\_CANDIDATES: a search does not look at all of it either, and counts that.
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
    BindingInfo { name: "grid", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
];

static RANK_BY_ID: Module = Module {
    name: "RankById",
    entry: "RankById",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/rank_by_id.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/rank_by_id.compute",
    hash: "310a971755dfb91c725176f61deac2693ced1c8f9067015a2f76b057356dcb55",
};
