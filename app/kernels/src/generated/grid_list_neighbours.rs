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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 15128 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "13e6aa3de99a185ad9458c9e99e33024e4274a00fbd7ee336004be76fc3cca92",
};

static LIST_NEIGHBOURS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15128, bytes: 14780 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "07b33921f422cd00eeeaa88eee58add12436f0d6a7ead4580402468175120023",
};

static LIST_NEIGHBOURS_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 29908, bytes: 17196 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "b0775d7c0aac77f4b67f0243810c5e81f9b7b49bce7a0bef2364b5f6e897bb84",
};

static LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 47104, bytes: 16848 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "e6d0433ccc7c6a19facf9367217debea581138f20cd7c9918a9788b1be51e8cf",
};

static LIST_NEIGHBOURS_WITH_WRAPPED: Module = Module {
    name: "ListNeighbours+WRAPPED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 63952, bytes: 18112 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "e7d9c11d861e9f88a0e5ccb40106ec83f0427f4779f04c0bbf35e107e1fbbac6",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 82064, bytes: 17764 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "bd3d8866ecca38afde10f8105474a676e825b7a5c17c89ffd56276338f016b42",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 99828, bytes: 19520 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "e5038aa8ba35fd6de7ab52b4f8dc921e18f4c9dd1efe2acc8d20baf985044237",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 119348, bytes: 19172 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "e7c9b6d9f49134400166bfc6e1bd3575c4a99f1ddf319fd7b2e2ec1423eb6080",
};
