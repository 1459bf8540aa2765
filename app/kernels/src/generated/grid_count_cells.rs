// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/count_cells.compute.
//! Kernels of `grid/count_cells.compute`.

use super::{CellSlot, GridParams, Position, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`CountCells`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CountCellsVariant {
    /// Keyword `WRAPPED`.
    pub wrapped: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// First pass of the counting sort: how many particles each cell holds, and how many of its cell
/// came before each particle. The atomic gives both at once, so the sort needs no second one.
#[derive(Debug)]
pub struct CountCells<'a> {
    /// Its variant.
    pub variant: CountCellsVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<uint> cell_counts`.
    pub cell_counts: BufMut<'a, u32>,
    /// `RWStructuredBuffer<CellSlot> cell_slots`.
    pub cell_slots: BufMut<'a, CellSlot>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
}

impl Kernel for CountCells<'_> {
    const STAGE: &'static str = "count_cells";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.wrapped, self.variant.periodic) {
            (false, false) => &COUNT_CELLS,
            (false, true) => &COUNT_CELLS_WITH_PERIODIC,
            (true, false) => &COUNT_CELLS_WITH_WRAPPED,
            (true, true) => &COUNT_CELLS_WITH_WRAPPED_WITH_PERIODIC,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("cell_counts", Some(self.cell_counts.id)),
                ("cell_slots", Some(self.cell_slots.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&COUNT_CELLS, &COUNT_CELLS_WITH_PERIODIC, &COUNT_CELLS_WITH_WRAPPED, &COUNT_CELLS_WITH_WRAPPED_WITH_PERIODIC];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "cell_counts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "cell_slots",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 4, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_count_cells.deflate"));

static COUNT_CELLS: Module = Module {
    name: "CountCells",
    entry: "CountCells",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4192 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/count_cells.compute",
    hash: "c5fa25b86ad7bc7b1193644e3a884360e69897ec73497abd489e5f874694b78f",
};

static COUNT_CELLS_WITH_PERIODIC: Module = Module {
    name: "CountCells+PERIODIC",
    entry: "CountCells",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4192, bytes: 4348 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/count_cells.compute",
    hash: "4977d86a292ee002fe21da820849368343f421da17dbb4eaede2bc95dd35b65c",
};

static COUNT_CELLS_WITH_WRAPPED: Module = Module {
    name: "CountCells+WRAPPED",
    entry: "CountCells",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8540, bytes: 4256 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/count_cells.compute",
    hash: "3bf37d2555dd6fd4f0e782e22b01f201e9cf4c29cfea9cbe36ff150a66730cdf",
};

static COUNT_CELLS_WITH_WRAPPED_WITH_PERIODIC: Module = Module {
    name: "CountCells+WRAPPED+PERIODIC",
    entry: "CountCells",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 12796, bytes: 4412 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/count_cells.compute",
    hash: "c7744e95b014c302fe2a6877c4d1677ec5a81b576f47af82f892e6d7e43ce428",
};
