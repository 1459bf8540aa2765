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
    hash: "c086046c0aa654220f183199d975500020b7192670816c56cb7f8d5b3c89becc",
};

static LIST_NEIGHBOURS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15332, bytes: 15948 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "502c01f6d90d6fada8a49ccaf8c7b531be43b73c5dc19eb2e6e6a2dca401774e",
};

static LIST_NEIGHBOURS_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 31280, bytes: 17400 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "5bcdd08f5cc6afac9ba1a5e57075fdff548c24cc6d4702187358b1c837437605",
};

static LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 48680, bytes: 18016 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "9ca68aa9da95c6706a027c83af0bd5fc1cb8761a018ba4b735e1fd207cb1050b",
};

static LIST_NEIGHBOURS_WITH_WRAPPED: Module = Module {
    name: "ListNeighbours+WRAPPED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 66696, bytes: 18316 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "398c8218dcabff6c33e6ac2f594a2f6c89c4a172da202ba71d064bd972d9fb64",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 85012, bytes: 18932 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "b0384ad5a2c354c1916bf1f61b7ceec8b8cbd294e258df47a73416a612c2a605",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 103944, bytes: 19724 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "a88fb5403bd7a8d22caf9c69a317b71cc59e2204fd44657b445ffe35c72cc2f6",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 123668, bytes: 20340 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "5805d86d970ecc1ba14979d1be63056270270fecf2afc19876e8f80fc73724ee",
};
