// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/constrain_density.compute.
//! Kernels of `solver/pbf/constrain_density.compute`.

use super::{
    CoarseCell, CoarseGridParams, ListHead, MomentumKeyword, PbfIteration, PbfParams, Position, PositionLambda,
    PrecisionKeyword, SmoothingKernelParams, StepParams, StepState,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`ConstrainDensity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConstrainDensityVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `MOMENTUM` or `ACCUMULATED_MOMENTUM` or `RESTRICTED_MOMENTUM`.
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
    /// `RWStructuredBuffer<CoarseCell> coarse_cells`.
    pub coarse_cells: Option<BufMut<'a, CoarseCell>>,
    /// `ConstantBuffer<CoarseGridParams> coarse`.
    pub coarse: Option<Uniform<'a, CoarseGridParams>>,
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
            (false, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM
            }
            (false, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (false, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION
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
            (true, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM
            }
            (true, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (true, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION
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
                ("coarse_cells", self.coarse_cells.as_ref().map(|bound| bound.id)),
                ("coarse", self.coarse.as_ref().map(|bound| bound.id)),
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
    &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION,
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
    BindingInfo {
        name: "coarse_cells",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 10, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "coarse", slot: 11, kind: BindingKind::Uniform { bytes: 80 } },
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
    BindingInfo {
        name: "lambda_totals",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "coarse_cells",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 10, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 11, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "coarse", slot: 12, kind: BindingKind::Uniform { bytes: 80 } },
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

static BINDINGS_10: &[BindingInfo] = &[
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

static BINDINGS_11: &[BindingInfo] = &[
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
    hash: "5277c5d9cda06460b8f976e72783508823e80a946f4fcc9439e9aabd5e1317a9",
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
    hash: "ff30f4d4ac8064b155372a0396bcbbe807905796e20e65a048baf153b4818f20",
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
    hash: "849aa4e8b8b18a5517067a198fdca7ee04477330965853180e4437fa67228314",
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
    hash: "98fc811ab572a7bf0085904c4775fa69cbacc571f3f099cb9c5be6601daa471f",
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
    hash: "2651064becb61ade1047fa1592c410d985e7d83c9ffc37967768c6e79588141d",
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
    hash: "66e0f76506e140e0c1a991fbf3f2beeda27db46d89bc8a29dd6862fcb10c93ea",
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
    hash: "56983b91c705b47de45c1343f3a4e726b573564924f2cc9498db243ec8f1b438",
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
    hash: "658483c3ef9f91c9a13890674f23f586517ada19a1f5157f7a9712e6b47e3d77",
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
    hash: "2362b9bebf60ea7044bc98d984b4fbeacf02d0b4b8bcdec492ea91ce53d1babd",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+restricted_momentum.spv"),
    bindings: BINDINGS_5,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "fb59455c079895d55ef7f8992a11427bf737fa2d1e41cfd184dfbbbd37738685",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+restricted_momentum+relaxed_precision.spv"),
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "763b9e3730c89a3a98aad8f937145230a9e32cd87ae3af84fc8794bca9c9a484",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+restricted_momentum+half_precision.spv"),
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "70d1e66db08fab1b5eb78fe9f593787bb7512d0ea195587da172ec8b044d3bf7",
};

static CONSTRAIN_DENSITY_WITH_WALLS: Module = Module {
    name: "ConstrainDensity+WALLS",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls.spv"),
    bindings: BINDINGS_7,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "2825d89cfc3ff7c98759de14bd24488b43521304564768e31a6c2fbea27abf5b",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+relaxed_precision.spv"),
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "f4bbb03dc87dfec63ee0fb84a42836af375c0662d29f40ff0e2a507422b9eb18",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+half_precision.spv"),
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "34d8060cd00e78990566248c63c70aa97047aaa93731d63afa259edd8442823e",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+momentum.spv"),
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "4336afad9c02fb19b284718f3255fc98169e5785d3c19a134137827004c64b90",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+momentum+relaxed_precision.spv"),
    bindings: BINDINGS_10,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "6c9b5e1758154718e8d6a57b2a52bc71cf1da9d38ea00037f7a8c4ea59a93f9a",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+momentum+half_precision.spv"),
    bindings: BINDINGS_10,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "5c143e6ab138c2827ad824b20e859367e23759d5fe4825636547a396ebf3df90",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+accumulated_momentum.spv"),
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "42cc29b4b38391df16f9c009b09a1573d53f6d2ef6a96985603c6b245c090a79",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+accumulated_momentum+relaxed_precision.spv"),
    bindings: BINDINGS_11,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "7514bdb46f2ad34bd0fbfd812ce14b4723f30fea3b309a860fa77cf3f35cef2a",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+accumulated_momentum+half_precision.spv"),
    bindings: BINDINGS_11,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "c99bcaaccdae54b8d7df993eadb8a926ae9d859d25fb47e47590875bc2002061",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+restricted_momentum.spv"),
    bindings: BINDINGS_5,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "ca074efe8ffe5e447f19bdec33c1fcd526186e071e1c511a8f501f78262226ce",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+restricted_momentum+relaxed_precision.spv"),
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "94ab55282edb8d1c7e1615c0e208ae1d66eafe360a307ca65a2f6350e014152f",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+restricted_momentum+half_precision.spv"),
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "961b95b639b109ccc67c36ea2c00ba8f71bef178a8af0ec05798a81819762c8d",
};
