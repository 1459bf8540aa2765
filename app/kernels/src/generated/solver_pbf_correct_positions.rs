// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/correct_positions.compute.
//! Kernels of `solver/pbf/correct_positions.compute`.

use super::{
    Counters, ListHead, PbfParams, Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, StepParams,
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
        match (self.variant.walls, self.variant.s_corr, self.variant.precision, self.variant.packed) {
            (false, false, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS,
            (false, false, PrecisionKeyword::Off, true) => &CORRECT_POSITIONS_WITH_PACKED,
            (false, false, PrecisionKeyword::RelaxedPrecision, false) => &CORRECT_POSITIONS_WITH_RELAXED_PRECISION,
            (false, false, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (false, false, PrecisionKeyword::HalfPrecision, false) => &CORRECT_POSITIONS_WITH_HALF_PRECISION,
            (false, false, PrecisionKeyword::HalfPrecision, true) => &CORRECT_POSITIONS_WITH_HALF_PRECISION_WITH_PACKED,
            (false, true, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS_WITH_S_CORR,
            (false, true, PrecisionKeyword::Off, true) => &CORRECT_POSITIONS_WITH_S_CORR_WITH_PACKED,
            (false, true, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (false, true, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (false, true, PrecisionKeyword::HalfPrecision, false) => &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION,
            (false, true, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED
            }
            (true, false, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS_WITH_WALLS,
            (true, false, PrecisionKeyword::Off, true) => &CORRECT_POSITIONS_WITH_WALLS_WITH_PACKED,
            (true, false, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (true, false, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (true, false, PrecisionKeyword::HalfPrecision, false) => &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION,
            (true, false, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED
            }
            (true, true, PrecisionKeyword::Off, false) => &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
            (true, true, PrecisionKeyword::Off, true) => &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_PACKED,
            (true, true, PrecisionKeyword::RelaxedPrecision, false) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (true, true, PrecisionKeyword::RelaxedPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (true, true, PrecisionKeyword::HalfPrecision, false) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION
            }
            (true, true, PrecisionKeyword::HalfPrecision, true) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED
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
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
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
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
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
    hash: "bc87828ba60e997d95a8fa64d1616876ac3efa4431104abcf707b0c45b183511",
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
    hash: "53a2c29bb8fc1b899629dd74147f297273dba4a5ec4a5e93b5bc66bfb7947f01",
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
    hash: "b1cdcbb3856809fa2939151727f957d12c55bd339a7611f78eb910c179900905",
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
    hash: "63750417892dc9f95cf22f75305005cdcfe38acfc3bd7e2dfc40052ca9e0aa16",
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
    hash: "eda5b0e5b171964035488328433cfb3ee64a3d7f1d656b2f4e7840b7bc08ae8d",
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
    hash: "050338d0b238036fc5298aa16596de23e2f5f800bf92032da3928fbe693deaa1",
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
    hash: "bd36b6e4c29c3043f9d96f3ee71b2105465fb8d967f57454f4823267d91ea06b",
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
    hash: "fb876587ff24fbbd192b01515860aaab029650f01ef68f747110c8421f8efcc5",
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
    hash: "b7186dea52f86295c7490de27ae62bd1609dc21a1c07ffab452daf6d006e404c",
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
    hash: "e39362432ac835651fed67319e9cfbd30faa04f78f4c8b2ac9b400ef261ca91b",
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
    hash: "e205cb220d9cad331e7ce8218a6148260a471dbcf7a81338d97ec34ef3d7f1c2",
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
    hash: "1995f5b7aad55eca0ab3425d8cf28732560c415d59c4fed1e6403bc331d6316b",
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
    hash: "23bcb38f12d9490e420b35b2e07a01eed827379757510ca0493a2d8c29dd02da",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "a9447f85ddc3092bc2473414e454603bf965fe59f857ca2ec9ab9376e91c81bf",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "b1e75a0e45ea2e57a28ff691e4ee9ed21e2b8f153d62d0c73e21ecef822830ad",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+relaxed_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "a41d03181fa39b5358425c83c1d25d0209a7f018c90897a777a52dfeb3d62ac2",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "5d62adc368e2d601df2369319453b249d359c2923b2b964cd6a240c66d62269b",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+half_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "fc5ef86267c4b566bfa35c5d979cf654f65fc16e044a62819cf98966f8497803",
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
    hash: "983e68b153e8d4a0b5f6bdd75f12e448542048bfb441997410019561ebb4aafd",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "f65085f97b05afa6a19de8d085971edf076dee2c2ed8481db2bf202172662201",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "7bdc70b1eeb281edeef043048bf4e1a7865199456943c226d8aee976351e9f52",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+RELAXED_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+relaxed_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "0d8f30ce2e4b88273177e89bd5d33e2752e0798da7fcf227a4533e94adc72d1b",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "87933e29446e1e215d0df960d01a0d493130569ed6f7c630ebee39b03fa9b51c",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+HALF_PRECISION+PACKED",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/correct_positions+walls+s_corr+half_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "dcb6de604ec0111c0b5b969a083fa5f76be8099288f3547af10dacd402ad4870",
};
