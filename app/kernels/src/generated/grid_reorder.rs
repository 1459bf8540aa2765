// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/reorder.compute.
//! Kernels of `grid/reorder.compute`.

use super::{CellSlot, GridParams, OnlyKeyword, Position, PrecisionKeyword, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`Reorder`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ReorderVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `VELOCITIES_ONLY` or `POSITIONS_ONLY`.
    pub only: OnlyKeyword,
}

/// Last pass of the counting sort: every attribute moves to its slot in cell order, so that the
/// solver's neighbours lie close together in memory (Hoetzlein 2014; the mobile deck's "locality"). Velocities and
/// positions in two dispatches are in memory at one time no more than once and a half: a phone's positions then stand
/// where its velocities stood.
#[derive(Debug)]
pub struct Reorder<'a> {
    /// Its variant.
    pub variant: ReorderVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Option<Buf<'a, Position>>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Option<Buf<'a, Velocity>>,
    /// `StructuredBuffer<CellSlot> cell_slots`.
    pub cell_slots: Buf<'a, CellSlot>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Option<BufMut<'a, Position>>,
    /// `RWStructuredBuffer<Velocity> sorted_velocities`.
    pub sorted_velocities: Option<BufMut<'a, Velocity>>,
    /// `RWStructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Option<BufMut<'a, [u32; 2]>>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Option<Uniform<'a, GridParams>>,
}

impl Kernel for Reorder<'_> {
    const STAGE: &'static str = "reorder";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.precision, self.variant.only) {
            (PrecisionKeyword::Off, OnlyKeyword::Off) => &REORDER,
            (PrecisionKeyword::Off, OnlyKeyword::VelocitiesOnly) => &REORDER_WITH_VELOCITIES_ONLY,
            (PrecisionKeyword::Off, OnlyKeyword::PositionsOnly) => &REORDER_WITH_POSITIONS_ONLY,
            (PrecisionKeyword::RelaxedPrecision, OnlyKeyword::Off) => &REORDER_WITH_RELAXED_PRECISION,
            (PrecisionKeyword::RelaxedPrecision, OnlyKeyword::VelocitiesOnly) => &REORDER_WITH_VELOCITIES_ONLY,
            (PrecisionKeyword::RelaxedPrecision, OnlyKeyword::PositionsOnly) => {
                &REORDER_WITH_RELAXED_PRECISION_WITH_POSITIONS_ONLY
            }
            (PrecisionKeyword::HalfPrecision, OnlyKeyword::Off) => &REORDER_WITH_RELAXED_PRECISION,
            (PrecisionKeyword::HalfPrecision, OnlyKeyword::VelocitiesOnly) => &REORDER_WITH_VELOCITIES_ONLY,
            (PrecisionKeyword::HalfPrecision, OnlyKeyword::PositionsOnly) => {
                &REORDER_WITH_RELAXED_PRECISION_WITH_POSITIONS_ONLY
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", self.positions.as_ref().map(|bound| bound.id)),
                ("velocities", self.velocities.as_ref().map(|bound| bound.id)),
                ("cell_slots", Some(self.cell_slots.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("sorted_positions", self.sorted_positions.as_ref().map(|bound| bound.id)),
                ("sorted_velocities", self.sorted_velocities.as_ref().map(|bound| bound.id)),
                ("quantized_positions", self.quantized_positions.as_ref().map(|bound| bound.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", self.grid.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &REORDER,
    &REORDER_WITH_VELOCITIES_ONLY,
    &REORDER_WITH_POSITIONS_ONLY,
    &REORDER_WITH_RELAXED_PRECISION,
    &REORDER_WITH_RELAXED_PRECISION_WITH_POSITIONS_ONLY,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "sorted_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_velocities",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "velocities", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "sorted_velocities",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "sorted_positions",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 6, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_reorder.deflate"));

static REORDER: Module = Module {
    name: "Reorder",
    entry: "Reorder",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4956 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/reorder.compute",
    hash: "78d0aede0ae0e95f1c8432a8f07085823599e4e31156e8986c4ee23142199886",
};

static REORDER_WITH_VELOCITIES_ONLY: Module = Module {
    name: "Reorder+VELOCITIES_ONLY",
    entry: "Reorder",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4956, bytes: 2680 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/reorder.compute",
    hash: "a5bd416e55f583aba39f602c6e6615a07c7d9bd3c2eb93f6bbed9339207b7d7a",
};

static REORDER_WITH_POSITIONS_ONLY: Module = Module {
    name: "Reorder+POSITIONS_ONLY",
    entry: "Reorder",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7636, bytes: 4348 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/reorder.compute",
    hash: "9cb227f3ce5ceb41adb2ef8741fa48ea8e6638150fddb1c7056994315f0c7ac8",
};

static REORDER_WITH_RELAXED_PRECISION: Module = Module {
    name: "Reorder+RELAXED_PRECISION",
    entry: "Reorder",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 11984, bytes: 5108 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/reorder.compute",
    hash: "3811ec4121c8de0d2fc7b1e274dd7fb8db200c06741fe581999f92c0399f6fec",
};

static REORDER_WITH_RELAXED_PRECISION_WITH_POSITIONS_ONLY: Module = Module {
    name: "Reorder+RELAXED_PRECISION+POSITIONS_ONLY",
    entry: "Reorder",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17092, bytes: 4500 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/reorder.compute",
    hash: "861d23eed984551f8da8daff74bf3a644944464486ec659bc78aef238fd1949c",
};
