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
/// lambda, as the fluid mirrored in it would, so that even pressure leaves a wall's layer alone.
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
    hash: "d3b6fe4f9eeee05bb2148408644404319e6e990aa10dcdb9a4a38b2f5f7751a8",
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
    hash: "5a38f1f36c8c6789b5990c602e36d8a5962bb2521cd39e9b6d10c4fd80b0167e",
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
    hash: "6d73949170874e2006c71254f9118e134a101b7713c98b58894f271fd462e09e",
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
    hash: "d788ed3147faaf9040378149285e807959cda969ea20b5b61501671491197a7f",
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
    hash: "b753ec92c5f1b505b6c29a9d786257b2dadf878f145ca0c1c48b86b88b372ac0",
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
    hash: "d619fa7ca2c651bf2cbd82a1f925c99f21094c6d70a6b11f6b30f62205ffea32",
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
    hash: "323fabbd153b601c4f3005ca6ab602fb592d0f97d488e09643424f24ac09e3b2",
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
    hash: "c4794de68b1846693f758314f568118597283510b1df477512bdbdf5b631ff9e",
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
    hash: "ce97bfe3cdc2cb6fc011af1884fbe9f08e94c719c4df383a801959b79c8b08ae",
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
    hash: "d5ddad528d88aed8e9490269c1be72eeae8e93bd114d5c95e58abcbb06cd358c",
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
    hash: "6c2358496a5bf7d3d49057ac80cff6123be50d1d2ff06734c3d15484fda41844",
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
    hash: "d20deccadf5adea0067373ad414e802777f1270ca320b5d2209af66756aa52a3",
};
