// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/constrain_density.compute.
//! Kernels of `solver/pbf/constrain_density.compute`.

use super::{
    ListHead, MomentumKeyword, PbfIteration, PbfParams, Position, PositionLambda, PrecisionKeyword,
    SmoothingKernelParams, StepParams, StepState,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`ConstrainDensity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConstrainDensityVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `MOMENTUM` or `ACCUMULATED_MOMENTUM`.
    pub momentum: MomentumKeyword,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// The density constraint's lambda of each particle (Macklin & Muller 2013, eq. 8-11).
#[derive(Debug)]
pub struct ConstrainDensity<'a> {
    /// Its variant.
    pub variant: ConstrainDensityVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: Option<BufMut<'a, PositionLambda>>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
    /// `RWStructuredBuffer<uint2> packed_position_lambdas`.
    pub packed_position_lambdas: Option<BufMut<'a, [u32; 2]>>,
    /// `ConstantBuffer<PbfIteration> iteration`.
    pub iteration: Option<Uniform<'a, PbfIteration>>,
    /// `RWStructuredBuffer<float> lambda_totals`.
    pub lambda_totals: Option<BufMut<'a, f32>>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Option<Buf<'a, Position>>,
}

impl Kernel for ConstrainDensity<'_> {
    const STAGE: &'static str = "constrain_density";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.momentum, self.variant.precision) {
            (false, MomentumKeyword::Off, PrecisionKeyword::Off) => &CONSTRAIN_DENSITY,
            (false, MomentumKeyword::Off, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION
            }
            (false, MomentumKeyword::Off, PrecisionKeyword::HalfPrecision) => &CONSTRAIN_DENSITY_WITH_HALF_PRECISION,
            (false, MomentumKeyword::Momentum, PrecisionKeyword::Off) => &CONSTRAIN_DENSITY_WITH_MOMENTUM,
            (false, MomentumKeyword::Momentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (false, MomentumKeyword::Momentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_HALF_PRECISION
            }
            (false, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM
            }
            (false, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (false, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION
            }
            (true, MomentumKeyword::Off, PrecisionKeyword::Off) => &CONSTRAIN_DENSITY_WITH_WALLS,
            (true, MomentumKeyword::Off, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (true, MomentumKeyword::Off, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION
            }
            (true, MomentumKeyword::Momentum, PrecisionKeyword::Off) => &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM,
            (true, MomentumKeyword::Momentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (true, MomentumKeyword::Momentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION
            }
            (true, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM
            }
            (true, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (true, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("position_lambdas", self.position_lambdas.as_ref().map(|bound| bound.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
                ("packed_position_lambdas", self.packed_position_lambdas.as_ref().map(|bound| bound.id)),
                ("iteration", self.iteration.as_ref().map(|bound| bound.id)),
                ("lambda_totals", self.lambda_totals.as_ref().map(|bound| bound.id)),
                ("sorted_positions", self.sorted_positions.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CONSTRAIN_DENSITY,
    &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 8, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 8, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "lambda_totals",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 9, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
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
        name: "position_lambdas",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_6: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
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
        name: "packed_position_lambdas",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_7: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
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
        name: "position_lambdas",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 9, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_8: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
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
        name: "packed_position_lambdas",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 9, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_9: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
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
        name: "packed_position_lambdas",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "lambda_totals",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 10, kind: BindingKind::Uniform { bytes: 16 } },
];

static CONSTRAIN_DENSITY: Module = Module {
    name: "ConstrainDensity",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "eb507d223428a98e3567ddab21d1fdf1c36dd6c6f14b670cecd98d96e655cf39",
};

static CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+relaxed_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "20454ea0e31822e5e11b76479880b0f4cfb7c90d5fafb93d133d8245789c2697",
};

static CONSTRAIN_DENSITY_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+half_precision.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "bf2b6be3c333652ffdacbb4e24900bfcfc4a5335e8eb1255dd479f1d307a9e59",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+momentum.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "a9647662f9fd6bbf4209a4e5d7352561890959fe1be47821fd462fddec8125fd",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+momentum+relaxed_precision.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "ca9f0a6a2db7fdddd2e294e9cdaf9b93f301c7ebf270901dd21f29b1371bf972",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+momentum+half_precision.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "2c657faa574c42d6c58f318dbfb3eec155e6f8fbe53c2dd0e36a09d3f2e7c891",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+accumulated_momentum.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "a2358324d2e107ec8a60af027c12d9fe19f8a6498d609542d13758b8a8945367",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+accumulated_momentum+relaxed_precision.spv"),
    bindings: BINDINGS_4,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "7d3d49566335937a0b4052b94d9db178053c2f43a6f16bd8ef23107e5978e8b8",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+accumulated_momentum+half_precision.spv"),
    bindings: BINDINGS_4,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "7a4a4642ebe93d692e473839b5c2092344132a03a3d8e4a7e1a7cc7897420431",
};

static CONSTRAIN_DENSITY_WITH_WALLS: Module = Module {
    name: "ConstrainDensity+WALLS",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls.spv"),
    bindings: BINDINGS_5,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "85912b9e676ba6a1b79d2b74da4092743d196993a8dd62bc5ad6c9abf2136ec5",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+relaxed_precision.spv"),
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "b9769d7d77145498b9cd022f5475021508cfbb21e0b4a2c59a238c9b01b01622",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+half_precision.spv"),
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "4c454d6feda8b9228375277a05bdd05e010050a4fbdb8c5083071d40a1f78e2e",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+momentum.spv"),
    bindings: BINDINGS_7,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "515e3a1b437fbed18e8171e5b6a8130b888fdf09e3058907d34c1a26cf54fa39",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+momentum+relaxed_precision.spv"),
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "4736f1aa43510ac61b9b363e7ddb19edbb11013f11717d6af22d7353b7fd69fe",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+momentum+half_precision.spv"),
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "1e549f5c5e51f7fdb905ad1c458495afbcff5138ed70b506a7b147bd8a78f915",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+accumulated_momentum.spv"),
    bindings: BINDINGS_7,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "04ea5f577fceff3340c8dbf1177909c47904b0145acbd697143f349b2cb11e13",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+accumulated_momentum+relaxed_precision.spv"),
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "bcc003eb7d9c5836b55fd7afad30b46597bf3d825fb3d3366c06f269b490433b",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+accumulated_momentum+half_precision.spv"),
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "2591b7a19d034fc09761243b2646c8a5510d4973848547ce341d9cdb0fd16658",
};
