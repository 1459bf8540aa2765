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
    hash: "205f1d8c0a644d5cd3818116bcaa1be0ba88b655735d988e822e2203466f58e4",
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
    hash: "956fc4f36348bbf59cacd0e96c419087cea5e02e61aa20729cfa4ac2e49a8c4e",
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
    hash: "9035b9c01fb5547ec7f2e23d55fe80d4b9aa258d60dd55f920c0d7a7e1b0a1b5",
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
    hash: "d8026c3c2435a30e5afc39e06d609011d6d8a634417f1ea2b5d632bd2aefcac9",
};
