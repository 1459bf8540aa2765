// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/correct_positions.compute.
//! Kernels of `solver/pbf/correct_positions.compute`.

use super::{
    Counters, ListHead, PbfParams, Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, StepParams,
    StepState,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`CorrectPositions`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CorrectPositionsVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `S_CORR`.
    pub s_corr: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// One Jacobi correction of the positions (Macklin & Muller 2013, eq. 12-14), under-relaxed:
/// plain Jacobi is unstable at ordinary neighbour counts. A wall answers with its particle's own
/// multiplier, as the fluid mirrored in it would, so that even pressure leaves a wall's layer alone.
#[derive(Debug)]
pub struct CorrectPositions<'a> {
    /// Its variant.
    pub variant: CorrectPositionsVariant,
    /// `StructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: Option<Buf<'a, PositionLambda>>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: BufMut<'a, [u32; 2]>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
    /// `StructuredBuffer<uint2> packed_position_lambdas`.
    pub packed_position_lambdas: Option<Buf<'a, [u32; 2]>>,
}

impl Kernel for CorrectPositions<'_> {
    const STAGE: &'static str = "correct_positions";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.s_corr, self.variant.precision) {
            (false, false, PrecisionKeyword::Off) => &CORRECT_POSITIONS,
            (false, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_POSITIONS_WITH_RELAXED_PRECISION,
            (false, false, PrecisionKeyword::HalfPrecision) => &CORRECT_POSITIONS_WITH_HALF_PRECISION,
            (false, true, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_S_CORR,
            (false, true, PrecisionKeyword::RelaxedPrecision) => &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION,
            (false, true, PrecisionKeyword::HalfPrecision) => &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION,
            (true, false, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_WALLS,
            (true, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, false, PrecisionKeyword::HalfPrecision) => &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION,
            (true, true, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
            (true, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (true, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("position_lambdas", self.position_lambdas.as_ref().map(|bound| bound.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
                ("packed_position_lambdas", self.packed_position_lambdas.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CORRECT_POSITIONS,
    &CORRECT_POSITIONS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "position_lambdas",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
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
    hash: "b0a5edd8a635991519f2e77b3ec45a965b893ad8b6782014139be886fcdc2c0d",
};

static CORRECT_POSITIONS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+relaxed_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "6c4d894a52978f0fe47bf5e328ba12a84442784468a0ceb0963b821f6694f2d9",
};

static CORRECT_POSITIONS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+half_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "61eacdffd81ee0ee32d8111ebfbda27c3d1317228ae17a968c22a1d39c461eca",
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
    hash: "de84c48cb77799abb2ec8fe6c36c5c5440919c4630fe2b314189c937b8effb08",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr+relaxed_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "a090d53ade4f17e4fbb7ad666a1fd70600faa34b851319abfdf4c385fea3b0ca",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+s_corr+half_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "17512b6839f4192586470458f9499f08bf692b502e4786b54d2726792e6f811e",
};

static CORRECT_POSITIONS_WITH_WALLS: Module = Module {
    name: "CorrectPositions+WALLS",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "8eb7a0a32c1aca741161e1272f628fd38d66ea433886bb2e7b8f0a080980b042",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+relaxed_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "f3f128e1985753ef4c0e809ba1686f561c89a204b5f27300384210257252a67e",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+half_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "da852081c812b32227c04461a2f5054ec4bce3a2679ea3491eb21e9eda99d94c",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "c0f4431d331b59df989597ba704c1bf392fd6f1e2ac7754cb07eafd11b130cb0",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+relaxed_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "3fcbe5464f376d3f8c09b69966920655725ee1cfb53444ac5346353830ac72b1",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+half_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "833af020e7c9ddcd82542898b2631b8178b362aee70807dc39beb29474460e79",
};
