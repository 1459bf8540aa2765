// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/list_neighbours.compute.
//! Kernels of `grid/list_neighbours.compute`.

use super::{Counters, GridParams, ListHead, Position, PrecisionKeyword, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
];

static LIST_NEIGHBOURS: Module = Module {
    name: "ListNeighbours",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "2ad0afe30e2a476620c26a9f97679d27da90492a73c1b1b3cf8ee2fd01bd20f0",
};

static LIST_NEIGHBOURS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "9f168c583348f4ce45fbc77352724a051c13ede57b4578fc232704bef5b4b6bf",
};

static LIST_NEIGHBOURS_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "f55c13268273f8c20289a36da6a9e0e15e10ce351800f7caaf7eedac19609c69",
};

static LIST_NEIGHBOURS_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+periodic+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "0644d00934c0542825b4dea185c39fd1033c5dab0ad05e8b03dbe75f3eee6825",
};

static LIST_NEIGHBOURS_WITH_WRAPPED: Module = Module {
    name: "ListNeighbours+WRAPPED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+wrapped.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "ea0d553c97785874dd584d076941f40ff6ba1a8316c9104f1be43951a001acc3",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+wrapped+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "c0dddbd2c945a13ade99d6ce73b23f093c9c00ac6e4d064c3146edf912c0850b",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+wrapped+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "213424b97953ba2302d08cb367c6a8f0d301c097bedcaf1796a78df25d2c7909",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_RELAXED_PRECISION: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC+RELAXED_PRECISION",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+wrapped+periodic+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "ce04787ad3ea6ee168586f12b8f43b65a12b5b8218ecc5672204d81cd32438cf",
};
