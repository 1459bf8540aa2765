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
                ("quantized_positions", Some(self.quantized_positions.id)),
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
    hash: "de1569c6a58b3ec08939bb75d07a00694e1d802e67a98ab034444e708c4b9da3",
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
    hash: "7f8122169ad51c387699d1d41c2bb4777fa32f5d9cd98cced030a30a092070fb",
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
    hash: "91a595446afe783e627cc0f534e2f828f60c3c70c60dd5de0d0ba9d51c4c3d32",
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
    hash: "8a41c8e794be2fd2011bf05e12b3055f6a48d6d9f9ffdf58dc51b6e691730b7c",
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
    hash: "6e2f175df7617e9c64a4949fea5a4d688fa36322d14a1b5850e418c84343d62d",
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
    hash: "93fd9c3b8e5b6c4b629009f42a28e3d1217196a21da88b07d2a5c8d8dc9a24cc",
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
    hash: "15f785b1da423be87f6ec49395127f2194c9a5a92b85ba0b1247c52f877a9505",
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
    hash: "73c0ff60bf12e7bff656bc06eee0529d75cf8a08fe5a08d97a1af809fd73f220",
};
