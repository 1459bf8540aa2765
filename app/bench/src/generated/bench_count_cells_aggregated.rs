// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/count_cells_aggregated.compute.
//! Kernels of `bench/count_cells_aggregated.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, CellSlot, GridParams, Kernel, Module, Position,
    Spirv, StageKind, StepState, Tier, Uniform, bind,
};

/// CountCells with aggregated atomics: particles of one cell that follow each other in a group share
/// one atomic, by whose first they are ranked. What `brooklet bench sorting` holds against it is
/// grid/count\_cells.compute.
#[derive(Debug)]
pub struct CountCellsAggregated<'a> {
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

impl Kernel for CountCellsAggregated<'_> {
    const STAGE: &'static str = "count_cells_aggregated";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COUNT_CELLS_AGGREGATED
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
pub(super) static MODULES: &[&Module] = &[&COUNT_CELLS_AGGREGATED];

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

static COUNT_CELLS_AGGREGATED: Module = Module {
    name: "CountCellsAggregated",
    entry: "CountCellsAggregated",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/count_cells_aggregated.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 512,
    tier: Tier::Floor,
    source: "bench/count_cells_aggregated.compute",
    hash: "b0ecb41e909d420a4ebd9c39a9d882382061a9bb5098461e62f8dc3c9d2d7412",
};
