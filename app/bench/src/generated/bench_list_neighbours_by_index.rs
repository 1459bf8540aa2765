// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/list_neighbours_by_index.compute.
//! Kernels of `bench/list_neighbours_by_index.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, GridParams, Kernel, Module, Position, Spirv,
    StageKind, StepState, Tier, Uniform, bind,
};

/// ListNeighbours where only the index was sorted: candidates are found through it, and the list
/// holds particles by where they lie, in no order, so that a neighbour takes 32 bits. What `brooklet
/// bench sorting` holds against it is grid/list_neighbours.compute.
#[derive(Debug)]
pub struct ListNeighboursByIndex<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint> sorted_indices`.
    pub sorted_indices: Buf<'a, u32>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint4> listed_indices`.
    pub listed_indices: BufMut<'a, [u32; 4]>,
    /// `RWStructuredBuffer<uint> listed_counts`.
    pub listed_counts: BufMut<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
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
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("sorted_indices", Some(self.sorted_indices.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("listed_indices", Some(self.listed_indices.id)),
                ("listed_counts", Some(self.listed_counts.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&LIST_NEIGHBOURS_BY_INDEX];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_indices",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "cell_starts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "listed_indices",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "listed_counts",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
];

static LIST_NEIGHBOURS_BY_INDEX: Module = Module {
    name: "ListNeighboursByIndex",
    entry: "ListNeighboursByIndex",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/list_neighbours_by_index.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/list_neighbours_by_index.compute",
    hash: "d87d71d91786aca3d0aaf56e64b0774161b3dd756581476ddde4ae3ca6721b35",
};
