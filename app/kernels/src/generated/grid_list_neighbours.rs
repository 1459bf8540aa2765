// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/list_neighbours.compute.
//! Kernels of `grid/list_neighbours.compute`.

use super::{Counters, GridParams, ListHead, Position};
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
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// Lists each particle's neighbours once a substep; every iteration reuses the list.
#[derive(Debug)]
pub struct ListNeighbours<'a> {
    /// Its variant.
    pub variant: ListNeighboursVariant,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> places`.
    pub places: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint2> neighbours`.
    pub neighbours: BufMut<'a, [u32; 2]>,
    /// `RWStructuredBuffer<ListHead> list_heads`.
    pub list_heads: BufMut<'a, ListHead>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
}

impl Kernel for ListNeighbours<'_> {
    const STAGE: &'static str = "list_neighbours";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.wrapped, self.variant.periodic, self.variant.packed) {
            (false, false, false) => &LIST_NEIGHBOURS,
            (false, false, true) => &LIST_NEIGHBOURS_WITH_PACKED,
            (false, true, false) => &LIST_NEIGHBOURS_WITH_PERIODIC,
            (false, true, true) => &LIST_NEIGHBOURS_WITH_PERIODIC_WITH_PACKED,
            (true, false, false) => &LIST_NEIGHBOURS_WITH_WRAPPED,
            (true, false, true) => &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PACKED,
            (true, true, false) => &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC,
            (true, true, true) => &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_PACKED,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("places", Some(self.places.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("counters", Some(self.counters.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &LIST_NEIGHBOURS,
    &LIST_NEIGHBOURS_WITH_PACKED,
    &LIST_NEIGHBOURS_WITH_PERIODIC,
    &LIST_NEIGHBOURS_WITH_PERIODIC_WITH_PACKED,
    &LIST_NEIGHBOURS_WITH_WRAPPED,
    &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PACKED,
    &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC,
    &LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_PACKED,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "sorted_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "places", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "grid", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
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
    hash: "4a396f6e58a59a395000b87f5437e08b7a8125d3e94e7a492e15851d63f8723a",
};

static LIST_NEIGHBOURS_WITH_PACKED: Module = Module {
    name: "ListNeighbours+PACKED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "71ecb6242ae84702b9f02ca9ebd1f29871678f042b9e3c354eebd5aab5cbe9be",
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
    hash: "9a2e9c7af055d329eabb435b773818fce35891e89a9188a3581a00af1250fc7c",
};

static LIST_NEIGHBOURS_WITH_PERIODIC_WITH_PACKED: Module = Module {
    name: "ListNeighbours+PERIODIC+PACKED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+periodic+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "9ebcf0822a1fbb8cfee5f405fec438bf51de10085cafd6f5e02c993b7588a593",
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
    hash: "d8560a52d829730ecdf2d02356cbebe626441814f539a81a808663adf97070e6",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PACKED: Module = Module {
    name: "ListNeighbours+WRAPPED+PACKED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+wrapped+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "df5b9c27cfe67587fa7678825c8252e6ef35c2a68cb6ec121e6b85337cbf6692",
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
    hash: "1b768406055edf2a36330cf981dbe6e20139c5b3b4e3546b903cc346761ac558",
};

static LIST_NEIGHBOURS_WITH_WRAPPED_WITH_PERIODIC_WITH_PACKED: Module = Module {
    name: "ListNeighbours+WRAPPED+PERIODIC+PACKED",
    entry: "ListNeighbours",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours+wrapped+periodic+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/list_neighbours.compute",
    hash: "5b37638b2c4356ec285e718319e87307bd86cd1bea854df18e3fffcb2e72ecd6",
};
