// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/list_neighbours_by_index.compute.
//! Kernels of `bench/list_neighbours_by_index.compute`.

use super::{Counters, GridParams, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// ListNeighbours where only the index was sorted: candidates are found through it, and the list
/// holds particles by where they lie. What `brooklet bench sorting` holds against it is
/// grid/list\_neighbours.compute.
#[derive(Debug)]
pub struct ListNeighboursByIndex<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint> sorted_indices`.
    pub sorted_indices: Buf<'a, u32>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
    /// `StructuredBuffer<uint2> places`.
    pub places: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint4> neighbours`.
    pub neighbours: BufMut<'a, [u32; 4]>,
    /// `RWStructuredBuffer<uint> neighbour_counts`.
    pub neighbour_counts: BufMut<'a, u32>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
}

impl Kernel for ListNeighboursByIndex<'_> {
    const STAGE: &'static str = "list_neighbours_by_index";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &LIST_NEIGHBOURS_BY_INDEX
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("sorted_indices", Some(self.sorted_indices.id)),
                ("grid", Some(self.grid.id)),
                ("places", Some(self.places.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("neighbour_counts", Some(self.neighbour_counts.id)),
                ("counters", Some(self.counters.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&LIST_NEIGHBOURS_BY_INDEX];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "sorted_indices",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "grid", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "places", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "neighbours",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "neighbour_counts",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "counters",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
];

static LIST_NEIGHBOURS_BY_INDEX: Module = Module {
    name: "ListNeighboursByIndex",
    entry: "ListNeighboursByIndex",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/list_neighbours_by_index.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/list_neighbours_by_index.compute",
    hash: "66c7db48af4a42fcfbf2eeba4dcaa12ff86f7ab6466b76ba4dd13f75a9391efb",
};
