// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/constrain_density.compute.
//! Kernels of `solver/pbf/constrain_density.compute`.

use super::{
    CoarseCell, CoarseGridParams, ListHead, MomentumKeyword, PbfIteration, PbfParams, Position, PositionLambda,
    PrecisionKeyword, SmoothingKernelParams, StepParams, StepState,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
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

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_constrain_density.deflate"));

static CONSTRAIN_DENSITY: Module = Module {
    name: "ConstrainDensity",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 9212 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "65f3c8e420aeca75aabdcfc92b6acfa48c81f71b7787752265f9ebbc57b79c30",
};

static CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 9212, bytes: 8744 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "ff82d630246146b3e724d9f13ddb4b26afd622880e7396b3c234b188e1e870f1",
};

static CONSTRAIN_DENSITY_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17956, bytes: 8696 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "3f5f239d2805d88634759b346e57d4c2ed6baabadd99ad3e7eacb915ba3a3ff5",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 26652, bytes: 10136 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "0eee35b9b1e3db957f692125fffff7c3556443dfb78cd96dabc34a0bf0f94e7e",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 36788, bytes: 9748 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "3f964754eaa6fced4dd3fec54b427a0679e881462906feffb93460429158be2d",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 46536, bytes: 9700 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "53312c189071d678779387e6e91be6b29f15cbde0e70c667e9332f4a6b2f1a67",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 56236, bytes: 10252 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "e85e98d39bdd5b08471eb49221710f4e81a65a8b167d47910dd74570d9beb2b6",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 66488, bytes: 10096 },
    bindings: BINDINGS_4,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "240f9b755e9fdf8fb405be8f375ff870d4b00b5f6b4d3bf4cc60eabcd77e4f26",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 76584, bytes: 10048 },
    bindings: BINDINGS_4,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "03eaad7703178f033c86335cb321bc3972e1a446f18af766c6e4bfa60ddc9003",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 86632, bytes: 13176 },
    bindings: BINDINGS_5,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "835ac1008e67ef7285a403a7ccc039c2764af03f4e4a0e4b336311521b2bbba8",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 99808, bytes: 13004 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "1e41b955e7623868dbde4492b73b482ff2d299e79e5d645c0a99aba305a9a5c1",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 112812, bytes: 12956 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "cd028478192713a84d31a7d0e462992d2418fc6bc962b486120e138aa818e3e4",
};

static CONSTRAIN_DENSITY_WITH_WALLS: Module = Module {
    name: "ConstrainDensity+WALLS",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 125768, bytes: 12664 },
    bindings: BINDINGS_7,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "45e048fea41ed5225dac6b59ca689a75504fa177a525d2adbb2d2adb4beddeec",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 138432, bytes: 12160 },
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "c9a62063144750d8b1717720f81f083ab0f139cd02a6b0dc5f6ba96a1c7494bf",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 150592, bytes: 12144 },
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "0d0ccf3ba657d0db7f1e6547e9cb6fd3cf6a4814c81e5c057ae459fddb630653",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 162736, bytes: 13588 },
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "1c515c668ae2d8a07a887f193270c38a5f1a9a9405bfcdab52d630567b585c90",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 176324, bytes: 13164 },
    bindings: BINDINGS_10,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "28cf7ea05578d3ac56a8e75e778a92cc9de5612bf67ae76e6b4dda2543a885a0",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 189488, bytes: 13148 },
    bindings: BINDINGS_10,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "dd968a013ae0b3c18a89824d8a94ffb90b7f03659f09b7f60a6fbbc1e65c3579",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 202636, bytes: 13704 },
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "8b892987eb7e9c2d1b68e12c38eca2c45dc483b497df87e5a2e1a448d6201eaf",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 216340, bytes: 13512 },
    bindings: BINDINGS_11,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "116770634bd5443d870696790a625bf87473775dd6d5bbfe6b266b5b0eccaebd",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 229852, bytes: 13496 },
    bindings: BINDINGS_11,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "06e80748cee203293f9301cf8b60d45529c1b6f681e0a5373c86fde3b59553ec",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 243348, bytes: 16260 },
    bindings: BINDINGS_5,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "cd7dcd2c223088c1148dce0bc0db66a3a8ba63e6a33ab9ae1e814eaeb8ef81cd",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 259608, bytes: 16052 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "76981ab507b68a7908d6e0e604fba716f04da3dc180a42feeb8a084d2982493d",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 275660, bytes: 16036 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "cbc21317fd6bb4648400fd183ded831579f6d9d9e0b468dac86505ccc7d50fa9",
};
