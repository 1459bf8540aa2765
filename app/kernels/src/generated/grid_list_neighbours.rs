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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_list_neighbours.deflate"));

static LIST_NEIGHBOURS: Module = Module {
    name: "ListNeighbours",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 15332 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "de4a6dfc817c43eb3d6b6fc4ab555ffdfcef79779cf6c35d3d448389db390121",
};

static LIST_NEIGHBOURS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15332, bytes: 14984 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "3cec831ef0d2c18b95ce227f32b3a23914f088d192ee70aaa0bd8e4ac8ecf12b",
};

static LIST_NEIGHBOURS_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30316, bytes: 17400 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "937320239a5ebbff4901000cabb384a0da69e0de012a272a5f50809841b96329",
};

static LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 47716, bytes: 17052 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "20243e0177cd5771ed89d6c358d966289e2783006313cdd620c68bcc3ca3b5d6",
};

static LIST_NEIGHBOURS_WITH_WRAPPED: Module = Module {
    name: "ListNeighbours+WRAPPED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 64768, bytes: 18316 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "58b7eeb9f1e22b9280210db10a16cbc2453ff0de34ba07769bfc74daabce8ee3",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 83084, bytes: 17968 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "ee29add0e0f5f6c7b5dc7a38c2637113de681b453e38328d26ff86836fff8b6f",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 101052, bytes: 19724 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "c54eedaff94c155c60b0079a65af58933bc140c861581da7c525c25e52c68881",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 120776, bytes: 19376 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "bd6f647259fc1659e8604f606492bbab987e464d79281858f48bbbb51cc2f44a",
};
