// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/correct_positions.compute.
//! Kernels of `solver/pbf/correct_positions.compute`.

use super::{Constrained, Counters, KernelParams, PbfParams, Position, PrecisionKeyword, StepParams, WallsKeyword};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`CorrectPositions`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CorrectPositionsVariant {
    /// Keyword `WALLS` or `NARROW_WALLS`.
    pub walls: WallsKeyword,
    /// Keyword `S_CORR`.
    pub s_corr: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// One Jacobi correction of the positions (Macklin & Muller 2013, eq. 12-14), under-relaxed:
/// plain Jacobi is unstable at ordinary neighbour counts. A wall answers with its particle's own
/// multiplier, as the fluid mirrored in it would, so that even pressure leaves a wall's layer alone.
#[derive(Debug)]
pub struct CorrectPositions<'a> {
    /// Its variant.
    pub variant: CorrectPositionsVariant,
    /// `StructuredBuffer<Constrained> constrained`.
    pub constrained: Option<Buf<'a, Constrained>>,
    /// `StructuredBuffer<uint4> neighbours`.
    pub neighbours: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<uint> neighbour_counts`.
    pub neighbour_counts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint2> places`.
    pub places: BufMut<'a, [u32; 2]>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<KernelParams> kernel`.
    pub kernel: Uniform<'a, KernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
    /// `StructuredBuffer<uint2> packed_constrained`.
    pub packed_constrained: Option<Buf<'a, [u32; 2]>>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Option<Buf<'a, Position>>,
    /// xyz: gradient over the three distances, 1/h; w: density ratio.
    ///
    /// `StructuredBuffer<float4> wall_weights`.
    pub wall_weights: Option<Buf<'a, [f32; 4]>>,
}

impl Kernel for CorrectPositions<'_> {
    const STAGE: &'static str = "correct_positions";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.s_corr, self.variant.precision, self.variant.packed) {
            (WallsKeyword::Off, false, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS,
            (WallsKeyword::Off, false, PrecisionKeyword::Off, true) => &CORRECT_POSITIONS_WITH_PACKED,
            (WallsKeyword::Off, false, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, false, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Off, false, PrecisionKeyword::HalfPrecision, false) => {
                &CORRECT_POSITIONS_WITH_HALF_PRECISION
            }
            (WallsKeyword::Off, false, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_HALF_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Off, true, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS_WITH_S_CORR,
            (WallsKeyword::Off, true, PrecisionKeyword::Off, true) => &CORRECT_POSITIONS_WITH_S_CORR_WITH_PACKED,
            (WallsKeyword::Off, true, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, true, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Off, true, PrecisionKeyword::HalfPrecision, false) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION
            }
            (WallsKeyword::Off, true, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS_WITH_WALLS,
            (WallsKeyword::Walls, false, PrecisionKeyword::Off, true) => &CORRECT_POSITIONS_WITH_WALLS_WITH_PACKED,
            (WallsKeyword::Walls, false, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::HalfPrecision, false) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
            (WallsKeyword::Walls, true, PrecisionKeyword::Off, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_PACKED
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::HalfPrecision, false) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, false, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS_WITH_NARROW_WALLS,
            (WallsKeyword::NarrowWalls, false, PrecisionKeyword::Off, true) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, false, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::NarrowWalls, false, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, false, PrecisionKeyword::HalfPrecision, false) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::NarrowWalls, false, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_HALF_PRECISION_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, true, PrecisionKeyword::Off, false) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR
            }
            (WallsKeyword::NarrowWalls, true, PrecisionKeyword::Off, true) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, true, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::NarrowWalls, true, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, true, PrecisionKeyword::HalfPrecision, false) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_HALF_PRECISION
            }
            (WallsKeyword::NarrowWalls, true, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("constrained", self.constrained.as_ref().map(|bound| bound.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("neighbour_counts", Some(self.neighbour_counts.id)),
                ("places", Some(self.places.id)),
                ("counters", Some(self.counters.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
                ("packed_constrained", self.packed_constrained.as_ref().map(|bound| bound.id)),
                ("sorted_positions", self.sorted_positions.as_ref().map(|bound| bound.id)),
                ("wall_weights", self.wall_weights.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CORRECT_POSITIONS,
    &CORRECT_POSITIONS_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_HALF_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_WALLS,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_HALF_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "constrained", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "places", slot: 3, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 } },
    BindingInfo {
        name: "counters",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "packed_constrained",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "places", slot: 3, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 } },
    BindingInfo {
        name: "counters",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "constrained", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "places", slot: 4, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 } },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo {
        name: "wall_weights",
        slot: 9,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo {
        name: "packed_constrained",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "places", slot: 4, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 } },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo {
        name: "wall_weights",
        slot: 9,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
];

static CORRECT_POSITIONS: Module = Module {
    name: "CorrectPositions",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "34ca6fd66c7122a8398fb3fb536f811a428123b4d86f17dde41ddbac12cab340",
};

static CORRECT_POSITIONS_WITH_PACKED: Module = Module {
    name: "CorrectPositions+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "7e52303d8d54af1d2733b2c00e3cb46123d6ac7cce554b639cff3c166671cd7a",
};

static CORRECT_POSITIONS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "c3ad4c24a6e550fc504edf84d94342b1d0ca6a5a34aa80a9c226b4e749b1da9a",
};

static CORRECT_POSITIONS_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+relaxed_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "68dea1d1b1ee393e1622dfe08b19e04d701c2befcd82a0e49583acfb9a6ed8c1",
};

static CORRECT_POSITIONS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "97a27c46d202572f339efb2a00552b6171b0bdfd680bef784e0736572f398b16",
};

static CORRECT_POSITIONS_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+half_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "e636f15d6d3aa185168a768cb82fe19ed5974a7dcc030686df6ff3b12dd9bf2d",
};

static CORRECT_POSITIONS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "44a9b8783583bd702f44aa8ede0b9b92a78db4b9ff16c045479e185b6c33d7b3",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_PACKED: Module = Module {
    name: "CorrectPositions+S_CORR+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "4109a89ce0d35e1a921adf06fbcd8722123d053520839cd4026ebf09d99535df",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "2592f1d12416f4c742946cdc88f1bd5e686f9ef3627ef2596feb62206ea3d1be",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+S_CORR+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr+relaxed_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "d2c2668ac7108ae741646ace9fe76fa955d3fffadc0c79b50ea52b492f98d9a2",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "ca8bdaa79b127ccf95d3dbdee8df8f07d630a79dba6d2bf4ac7d11bf77fb983f",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+S_CORR+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr+half_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "e6ee6ace46c754895f1aa4cf77a998827b32c6aa9527a5b844a076dfe3dadc50",
};

static CORRECT_POSITIONS_WITH_WALLS: Module = Module {
    name: "CorrectPositions+WALLS",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "dec94a487c1548960bd3612cde11f35067adba5aeb1dc440f956fe2bcef571e7",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "f12920041cb9840b00f56421c7f025eb547fa08303906fe15c5106f3f204d56c",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+relaxed_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "9865d314bed58835e72030c45f648e4d5ad2c3a3ad854faf24827c06107537a7",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+relaxed_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "0db729348e440340e07f321e3d17fea649cf0755a7341d6f1115569e679a3778",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+half_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "41ac8737f1bb8a51e8f2125aef551bae68417de29b2c8a62db495b453d2d5c43",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+half_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "0a851585198515eae258b95c4adc622cf5c7be1762602475c8f4150876173950",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "89c777a4528c3d64a6c58da12d63132078a51bbf0e422ae82e20ae490366f43f",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "0b9960e0ed5cc7f0b0f6d6d7d16d0ad46eef1b180756964368f5f6ebccc13ece",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+relaxed_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "43d6ac489b3b8cee84e0eb2f79cf92fd9fe7380bb7636ff120fc7b598778dc5c",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+relaxed_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "ef6e4d90a9a8ead451d1459f44dfe1a1abb03c0ec6c546a5a9f543e4ecfee82e",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+half_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "b77cc6a8d857fac85381353067a6b1f058d4e40fc8b42c8ce79c98f582b01dc7",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+half_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "c6b693adb27a1755825206aed8105bcdb6a13c2fb04613166d67e1a7950ab2bb",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS: Module = Module {
    name: "CorrectPositions+NARROW_WALLS",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "f2761ae7d1406a9abe1cd06a201da2a776a7098b2a39f80b6d53501cfedf1208",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_PACKED: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "a1bb48c4f765a81a881197a8899674fef4f29329b6c17276ac1257d31f7a04cf",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+relaxed_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "2c33d571126b813639922da4bd83ea14a824248b64aa373162e1ef281076df70",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+relaxed_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "f2ac7a5ebfdfaeeb971d8f433f2e7119be68a1adef19f5eb121077a1c0ac6d74",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+half_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "5a35c8345ca8b694cfd9ca5bb3138de414724500225441308a5c4fb460fb53e2",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+half_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "0c6c0346e1691fab30dd506f0ab86f5a4f3e458a78b116126bcca92e6f7ae7ab",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+s_corr.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "5d1f41e78171b56102e4410b637da93d790ac14a1d8ed06ee8c415724458d06a",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_PACKED: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+S_CORR+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+s_corr+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "729abd6d8a1c8ced2b361d4ee3d9dd28a40188eeb1e1caf857ec18442be20529",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+s_corr+relaxed_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "3b554e698f7053b7cf2316ac18158b2df283543efd02969851323937df9047ea",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+S_CORR+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+s_corr+relaxed_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "3cf07438b5128c66206cdb861ffa155328cc211a9cbdb89cad8aa11d2e129e9f",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+s_corr+half_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "1a91dd1330cc9e29f866285576e274d01273d0b37ad858ce38bc6cc885443180",
};

static CORRECT_POSITIONS_WITH_NARROW_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+NARROW_WALLS+S_CORR+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+narrow_walls+s_corr+half_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "556e67831ddf87ddb384bfe5f7d530d0d4b58218a04c3ee2eb855741a231f7fe",
};
