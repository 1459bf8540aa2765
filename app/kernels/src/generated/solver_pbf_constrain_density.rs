// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/constrain_density.compute.
//! Kernels of `solver/pbf/constrain_density.compute`.

use super::{
    CoarseCell, CoarseGridParams, ListHead, MomentumKeyword, PbfIteration, PbfParams, Position, PositionLambda,
    PrecisionKeyword, SmoothingKernelParams, SolidContact, StepParams, StepState, WallsKeyword,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ConstrainDensity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConstrainDensityVariant {
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
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
    /// `StructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Option<Buf<'a, SolidContact>>,
}

impl Kernel for ConstrainDensity<'_> {
    const STAGE: &'static str = "constrain_density";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.momentum, self.variant.precision) {
            (WallsKeyword::Off, MomentumKeyword::Off, PrecisionKeyword::Off) => &CONSTRAIN_DENSITY,
            (WallsKeyword::Off, MomentumKeyword::Off, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, MomentumKeyword::Off, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_HALF_PRECISION
            }
            (WallsKeyword::Off, MomentumKeyword::Momentum, PrecisionKeyword::Off) => &CONSTRAIN_DENSITY_WITH_MOMENTUM,
            (WallsKeyword::Off, MomentumKeyword::Momentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, MomentumKeyword::Momentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::Off, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM
            }
            (WallsKeyword::Off, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::Off, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM
            }
            (WallsKeyword::Off, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::Off, PrecisionKeyword::Off) => &CONSTRAIN_DENSITY_WITH_WALLS,
            (WallsKeyword::Walls, MomentumKeyword::Off, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::Off, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::Momentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM
            }
            (WallsKeyword::Walls, MomentumKeyword::Momentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::Momentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM
            }
            (WallsKeyword::Walls, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM
            }
            (WallsKeyword::Walls, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::Off, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::Off, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::Off, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::Momentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::Momentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::Momentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::AccumulatedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::Off) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::RelaxedPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, MomentumKeyword::RestrictedMomentum, PrecisionKeyword::HalfPrecision) => {
                &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION
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
                ("solid_contacts", self.solid_contacts.as_ref().map(|bound| bound.id)),
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
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION,
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
    BindingInfo { name: "coarse", slot: 11, kind: BindingKind::Uniform { bytes: 96 } },
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
    BindingInfo { name: "coarse", slot: 12, kind: BindingKind::Uniform { bytes: 96 } },
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

static BINDINGS_12: &[BindingInfo] = &[
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
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_13: &[BindingInfo] = &[
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
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_14: &[BindingInfo] = &[
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
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 10, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_15: &[BindingInfo] = &[
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
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 10, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_16: &[BindingInfo] = &[
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
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "lambda_totals",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 10, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 11, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_17: &[BindingInfo] = &[
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
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
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
    BindingInfo { name: "coarse", slot: 12, kind: BindingKind::Uniform { bytes: 96 } },
];

static BINDINGS_18: &[BindingInfo] = &[
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
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "lambda_totals",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "coarse_cells",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 11, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "iteration", slot: 12, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "coarse", slot: 13, kind: BindingKind::Uniform { bytes: 96 } },
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
    hash: "f5ab6cb54db9407bfb6f2c913dbaa9148219137494fdae7536e7b7da87b91b19",
};

static CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 9212, bytes: 9120 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "642eac1e20b81aab0cd427cd0b595f718ca405bd44becc7ba5c3c063dfbaf724",
};

static CONSTRAIN_DENSITY_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 18332, bytes: 9072 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "6c57d48f699e3912d72e32406cf35479cf78671b2c64fbdd06a50d13b8317940",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 27404, bytes: 10136 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "37d80429a4dd9a08f9ff1a12b807adb87a0e3ad106ca841048573fd85dc9366a",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 37540, bytes: 10124 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "cded2045d7f6ade9445c856440a49b68dd2589c0fce40622677b02402e6f0317",
};

static CONSTRAIN_DENSITY_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 47664, bytes: 10076 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "cda6dfc3aa7d75e2044a5e903467a1c67a2dd189e4ea7c5b37b9f854a7f046ae",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 57740, bytes: 10252 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "a617fd30f47782bfb53251ce58e237f449c38d46b6110934e08688dca23d4b06",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 67992, bytes: 10472 },
    bindings: BINDINGS_4,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "b899acf7dab714030749bbab44dc1691ed51ee9b7651cc573cf942c210696b7f",
};

static CONSTRAIN_DENSITY_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 78464, bytes: 10424 },
    bindings: BINDINGS_4,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "e6030254147c0d5bd85f86e314ade370c4194690c5837843cef72d636cae30b1",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 88888, bytes: 13364 },
    bindings: BINDINGS_5,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "6f7da4dfeca1e2257c1ac9b865a0c924bbd4122deb28d5322f61808f6d3b8679",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 102252, bytes: 13568 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "dd4925c4aa9ef2b3aaefcb6b4d34c1c75398da60ac31328e18507de111b51a7a",
};

static CONSTRAIN_DENSITY_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+RESTRICTED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 115820, bytes: 13520 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "21b775b9d3f09e5925e4159fed359a67714c531de365eb1d3e90c1f7def32f63",
};

static CONSTRAIN_DENSITY_WITH_WALLS: Module = Module {
    name: "ConstrainDensity+WALLS",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 129340, bytes: 12664 },
    bindings: BINDINGS_7,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "e034a6af8e5f7adcba385a7e058e09dbc57871f8e06676a6373c1f31217d4e45",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 142004, bytes: 13088 },
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "0ef0fe0e06cf15b2ae4bbca3b65cafac83044b465da3ef06c9122714265555b9",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 155092, bytes: 13072 },
    bindings: BINDINGS_8,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "3d6a2794f226219e51f2a76d568e74740727d39472ab5aea3407a450edf770f9",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 168164, bytes: 13588 },
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "5c51ca1bbed3a0f80bee9a927b787c2e2fbc78f4cf10b7053b734ef63a744ef8",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 181752, bytes: 14092 },
    bindings: BINDINGS_10,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "34dab69b9182feb7b71fcdc719992422d5ec7c5011b9bd72ee8af748fffffcef",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 195844, bytes: 14076 },
    bindings: BINDINGS_10,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "babede8387317e9cebe8b77a6563496111de3f7697e706a534a949189f3ed0cc",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 209920, bytes: 13704 },
    bindings: BINDINGS_9,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "03f145273c1087482d5aa984e0812492cff172c3cf8562d01f85e53acf84c2a8",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 223624, bytes: 14440 },
    bindings: BINDINGS_11,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "a70328be3438fd5d525bf455551952e0c74184c62194182cc87c18ce4f111c58",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 238064, bytes: 14424 },
    bindings: BINDINGS_11,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "4c63a309c1e86553bed29775d4b33c3628cea13709d34fbc59df33e6bf0cb28b",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 252488, bytes: 16448 },
    bindings: BINDINGS_5,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "e09c55a35b35401800e9c5f39810a7a67551e2b7a66fc4bdeea9bb8be6bd091b",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 268936, bytes: 17168 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "28cef0654e650e96769ace986dbab3b5f397bcb0b4b5bab9d866f2a1b2cb7e5f",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RESTRICTED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 286104, bytes: 17152 },
    bindings: BINDINGS_6,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "299ad541e6c0a959c72f9d152e6f4d4c876fc7d5f72e7db3785ca5130b9d29e5",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 303256, bytes: 14400 },
    bindings: BINDINGS_12,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "963e3d7f0def73df74ee77e5495ececf8740bc466623395831529adaa3b0ee71",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 317656, bytes: 14824 },
    bindings: BINDINGS_13,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "71d7b27d283925d31083bc555eea89b4ad3ca08d98f6b632f04c833fdd15d5da",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 332480, bytes: 14808 },
    bindings: BINDINGS_13,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "f00e7dd0c90babf64172ee297b7bf4230355db4e5c0d74df6a43bc9f9e233283",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 347288, bytes: 15324 },
    bindings: BINDINGS_14,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "eff0ba721d7ca06ea575feea84d374f69423252772317c11c7ee7ed9b7511dc8",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 362612, bytes: 15828 },
    bindings: BINDINGS_15,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "d39042a1246deb0d51df6e69348f5eeb4e04c2c024933a94064e8a4ccdcfa54a",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 378440, bytes: 15812 },
    bindings: BINDINGS_15,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "4d66accc8bf5401f2172534ffb37cf35663a456ef105027dcd2abd7c9a483971",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+ACCUMULATED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 394252, bytes: 15440 },
    bindings: BINDINGS_14,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "186e853640973079e39b7da765b07df468ea95705c3291bb50cd254a381d763c",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+ACCUMULATED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 409692, bytes: 16176 },
    bindings: BINDINGS_16,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "44b923c13ee281d9461dde6727bd7ca16932f6d5089b0c59866cafb83d7a5974",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_ACCUMULATED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+ACCUMULATED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 425868, bytes: 16160 },
    bindings: BINDINGS_16,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "ed56e8c9df3f40fe7cdb82031ce2e40a09745c4ba1aee9781dba0fb5d2799843",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+RESTRICTED_MOMENTUM",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 442028, bytes: 18184 },
    bindings: BINDINGS_17,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "0054c2b72383173a6a4ec6e02342c384e08fd00e19afc1bfad09cf4ea8e82895",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+RESTRICTED_MOMENTUM+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 460212, bytes: 18904 },
    bindings: BINDINGS_18,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "2134b3584b836cc2337792562f989955f47ec4f27f92349273c2fefbdaee001d",
};

static CONSTRAIN_DENSITY_WITH_SOLID_WALLS_WITH_RESTRICTED_MOMENTUM_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+SOLID_WALLS+RESTRICTED_MOMENTUM+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 479116, bytes: 18888 },
    bindings: BINDINGS_18,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "012cdf25a48a0495d04eda1c561d93cab173a83774ceac1d04cfb2d124fe7e6b",
};
