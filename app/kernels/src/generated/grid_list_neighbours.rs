// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/list_neighbours.compute.
//! Kernels of `grid/list_neighbours.compute`.

use super::{Counters, GridParams, ListHead, Position, PrecisionKeyword, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ListNeighbours`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ListNeighboursVariant {
    /// Keyword `WRAPPED`.
    pub wrapped: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// Lists each particle's neighbours once a substep; every iteration reuses the list.
#[derive(Debug)]
pub struct ListNeighbours<'a> {
    /// Its variant.
    pub variant: ListNeighboursVariant,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint2> neighbours`.
    pub neighbours: BufMut<'a, [u32; 2]>,
    /// `RWStructuredBuffer<ListHead> list_heads`.
    pub list_heads: BufMut<'a, ListHead>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
}

impl Kernel for ListNeighbours<'_> {
    const STAGE: &'static str = "list_neighbours";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.wrapped, self.variant.periodic, self.variant.precision) {
            (false, false, PrecisionKeyword::Off) => &LIST_NEIGHBOURS,
            (false, false, PrecisionKeyword::RelaxedPrecision) => &LIST_NEIGHBOURS_WITH_RELAXED_PRECISION,
            (false, false, PrecisionKeyword::HalfPrecision) => &LIST_NEIGHBOURS_WITH_RELAXED_PRECISION,
            (false, true, PrecisionKeyword::Off) => &LIST_NEIGHBOURS_WITH_PERIODIC,
            (false, true, PrecisionKeyword::RelaxedPrecision) => &LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION,
            (false, true, PrecisionKeyword::HalfPrecision) => &LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION,
            (true, false, PrecisionKeyword::Off) => &LIST_NEIGHBOURS_WITH_WRAPPED,
            (true, false, PrecisionKeyword::RelaxedPrecision) => &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION,
            (true, false, PrecisionKeyword::HalfPrecision) => &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION,
            (true, true, PrecisionKeyword::Off) => &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC,
            (true, true, PrecisionKeyword::RelaxedPrecision) => {
                &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION
            }
            (true, true, PrecisionKeyword::HalfPrecision) => {
                &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &LIST_NEIGHBOURS,
    &LIST_NEIGHBOURS_WITH_RELAXED_PRECISION,
    &LIST_NEIGHBOURS_WITH_PERIODIC,
    &LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION,
    &LIST_NEIGHBOURS_WITH_WRAPPED,
    &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION,
    &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC,
    &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "sorted_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "cell_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "neighbours",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "list_heads",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_list_neighbours.deflate"));

static LIST_NEIGHBOURS: Module = Module {
    name: "ListNeighbours",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 15120 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "768a3478020b1ce807e6450eba9e5b664f64f50f90fff869a0819826011cf64e",
};

static LIST_NEIGHBOURS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15120, bytes: 15736 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "c3fbc090129972746205c9af7053df18c89a7c09ffb15acf6cc5049901880799",
};

static LIST_NEIGHBOURS_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30856, bytes: 17188 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "bd2393cc195d75489d62db4a1288203fc79fea32ed8d2df93adf950c4b41803e",
};

static LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 48044, bytes: 17804 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "e424af2aed7e58d6598aabfa540012ec9e7c432f08bdda32639fa303417e4121",
};

static LIST_NEIGHBOURS_WITH_WRAPPED: Module = Module {
    name: "ListNeighbours+WRAPPED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 65848, bytes: 18104 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "0025278ae02941ba7c910cd097587b54bd6a7cca68f1f8109cb68cc2df3bba68",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 83952, bytes: 18720 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "0488e9ac166099b492f231665247b002bce9023ad70f3ee84bf79023ba19b359",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 102672, bytes: 19512 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "be2b6d2e1c58948814b48b2512c97e64f21dd6fe2d393b5d8f3ad3cff762607d",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 122184, bytes: 20128 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "6fd87037b65c806abce05b9429d4a72be351513c80c4d7e990ea6704fc5b59d4",
};
