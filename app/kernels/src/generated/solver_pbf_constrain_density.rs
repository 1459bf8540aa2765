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
    hash: "07e2032c5cb92f1ab8c89d7f78557fa73413c45dd2db6f84a0a8a0964bdc0fa2",
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
    hash: "bb765cf54645034ae2d2abe107b68f93c19cc44e7e6a49a0c42cfc2fc22cfbeb",
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
    hash: "ec3e1e46c9fa46cd775fbcc355b8acb386bd66240f83894467025c10ff57635a",
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
    hash: "251b8a3c43ccd82a99a10fea9d4e6f00a62b860dd8e76a7dbdeb7c8c16eb8fad",
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
    hash: "552ef5994eab460f487dd259006c4e012f2e93f00b4137eee92521270f8d5435",
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
    hash: "ada10b34a84794705502f8f7699d7f29b7b879350413a418dae9ad9fcbea6e95",
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
    hash: "847d075bf9911c85faede5ecbfe5b4886600d97e3cb1b9208c15e24b15ff4904",
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
    hash: "313bf1be42cd9be528a8ebf07b0ddfe98b6283722bef957ddc891cdea4093572",
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
    hash: "efc2d8ae7c04d3c16c0988dfff12fa00d9905485d46d14023d614a88d8a27d77",
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
    hash: "e3722900ee00db89fed6017e6660ebdc176520df42c711fcf3578bdeff3572ea",
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
    hash: "6a71b7d682658d4c7a725c71c867f270f2ffd049165aeacd56347af2eb3866f5",
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
    hash: "7baacb9df99f432cfb004609842c9423d5c508d3803158a9e65bfb8a1a2618a3",
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
    hash: "686b0f178bb9f545f8767939b7bbf78e77565eaceea5573c4f67674948d29097",
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
    hash: "a4b0eb700a97f6551e8cf676e423223b771b76e2b7ed70f43858f0c25f0a01bb",
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
    hash: "7ea77c7448cb4314d1c32970eb930ca039a890728d1c74253d1d3768a9f8bd6f",
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
    hash: "2e1289bdd57e2f33f337cd7b88e7a22a94a34492adacfd5a3cdc0e0d269ce4c3",
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
    hash: "4cb628207690dd36d0dcce96ca472e70a488818fc7d8476a562a051d0850677b",
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
    hash: "1e8cd13875efe8dd497776c0742239921b66b07354a8daad5233ec88124061b8",
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
    hash: "0d21c7fb9d6660fbe2bb67fc2917ec5fcc7637402a549808ff00a723acf09266",
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
    hash: "069756df62ef711a1d57803657cb4980501af8a0dcd0c51ff8f5f90ecf102014",
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
    hash: "f0f39867d04f0605ca8f3d068955a2ac920f21f905be3c3fa2a097719cea2ba8",
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
    hash: "5536b7ce7923b0122cccd2d2056ce366f209c0554931ec4766ce75b0f1b349bf",
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
    hash: "eb82f8d5848c53889546a8bebfbbff77d86bc3986595a950b251a05e55607323",
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
    hash: "e0d0a81f5c2f090db8e38bfb943848161137aa2c18dca6f6f7b6e765e1fcec97",
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
    hash: "fc8f55192366331b811de3d538e2b6f210cfce6efe6bed10bd8bf470c3b2e191",
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
    hash: "3277812fdebea81ae862c6b9acac238ef53232f8748a7b71d688c9d569cc791a",
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
    hash: "96bf99cdf5cb169a9120fb1569dfa9acef002ba831afbea238a9643777d77c5f",
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
    hash: "b08424a90696aa6e73f2609fbd5103216a29a36fcde747e2da98e116a143d477",
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
    hash: "2bc7008e013004e015a00b00e358c15b3c6078fa5eaa1b7d5b3046e1a65451f0",
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
    hash: "ff6ae0bdc3c2259f8f1486fc29564f01de5aef6a6227f87af76f0e1b6b2bd510",
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
    hash: "102e5c77b0c9ca311bac165808d2b61fd29e12fb70c57465b3131ba15e3ce663",
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
    hash: "6a2d2c8aaddd32f23118e1b525b1c6daeaf5a45c94ef4bbfe6f53db5c3a009fd",
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
    hash: "4150aeab897c55b203ae15edc2d72696d71d8669df0e622044762c2150885624",
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
    hash: "84c588b3c99cc54835aedd40645fdaffec1fef49ccfbf5fbf59c839b90a2f288",
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
    hash: "7becfb2ce723654f3d4e0d8ac9c96e93a39f6f08555bb579733baf1a9ad3c79b",
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
    hash: "d3217c8a6c4d1900a3074f6cb704928b44bfda1f146b69b23d15d97dedb9118d",
};
