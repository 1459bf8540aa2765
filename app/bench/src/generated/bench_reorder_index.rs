// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/reorder_index.compute.
//! Kernels of `bench/reorder_index.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, CellSlot, GridParams, Kernel, Module, Position,
    Spirv, StageKind, StepState, Tier, Uniform, bind,
};

/// The counting sort without locality: only each particle's index moves to cell order, and what is
/// known of a particle stays where it is. What `brooklet bench sorting` holds against it is
/// grid/reorder.compute.
#[derive(Debug)]
pub struct ReorderIndex<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<CellSlot> cell_slots`.
    pub cell_slots: Buf<'a, CellSlot>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> sorted_indices`.
    pub sorted_indices: BufMut<'a, u32>,
    /// `RWStructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: BufMut<'a, [u32; 2]>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
}

impl Kernel for ReorderIndex<'_> {
    const STAGE: &'static str = "reorder_index";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &REORDER_INDEX
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("cell_slots", Some(self.cell_slots.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("sorted_indices", Some(self.sorted_indices.id)),
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&REORDER_INDEX];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "sorted_indices",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 6, kind: BindingKind::Uniform { bytes: 64 } },
];

static REORDER_INDEX: Module = Module {
    name: "ReorderIndex",
    entry: "ReorderIndex",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/reorder_index.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/reorder_index.compute",
    hash: "c9b92a01d41b03cff219b465d838e9725cdecf4e23b771aac366b69bfcbcc2c9",
};
