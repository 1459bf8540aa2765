// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/prolong_multiplier.compute.
//! Kernels of `solver/pbf/prolong_multiplier.compute`.

use super::{CoarseGridParams, Position, PositionLambda, PrecisionKeyword, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ProlongMultiplier`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ProlongMultiplierVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// The coarse multiplier, interpolated, in the lambdas of a substep's first iteration.
#[derive(Debug)]
pub struct ProlongMultiplier<'a> {
    /// Its variant.
    pub variant: ProlongMultiplierVariant,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<float> multipliers`.
    pub multipliers: Buf<'a, f32>,
    /// `RWStructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: Option<BufMut<'a, PositionLambda>>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<CoarseGridParams> coarse`.
    pub coarse: Uniform<'a, CoarseGridParams>,
    /// `RWStructuredBuffer<uint2> packed_position_lambdas`.
    pub packed_position_lambdas: Option<BufMut<'a, [u32; 2]>>,
    /// What particles take of the multiplier, beside the total before the first iteration; then that alone.
    ///
    /// `RWStructuredBuffer<float> lambda_totals`.
    pub lambda_totals: Option<BufMut<'a, f32>>,
}

impl Kernel for ProlongMultiplier<'_> {
    const STAGE: &'static str = "prolong_multiplier";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match self.variant.precision {
            PrecisionKeyword::Off => &PROLONG_MULTIPLIER,
            PrecisionKeyword::RelaxedPrecision => &PROLONG_MULTIPLIER_WITH_RELAXED_PRECISION,
            PrecisionKeyword::HalfPrecision => &PROLONG_MULTIPLIER_WITH_RELAXED_PRECISION,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("multipliers", Some(self.multipliers.id)),
                ("position_lambdas", self.position_lambdas.as_ref().map(|bound| bound.id)),
                ("step_state", Some(self.step_state.id)),
                ("coarse", Some(self.coarse.id)),
                ("packed_position_lambdas", self.packed_position_lambdas.as_ref().map(|bound| bound.id)),
                ("lambda_totals", self.lambda_totals.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&PROLONG_MULTIPLIER, &PROLONG_MULTIPLIER_WITH_RELAXED_PRECISION];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "sorted_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "multipliers", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "position_lambdas",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "coarse", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "sorted_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "multipliers", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "lambda_totals",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "coarse", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_prolong_multiplier.deflate"));

static PROLONG_MULTIPLIER: Module = Module {
    name: "ProlongMultiplier",
    entry: "ProlongMultiplier",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 15944 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/prolong_multiplier.compute",
    hash: "6fb6c9e674bfc5dc15b829e423a80de271b09c03d42729375eddf690da3a4dda",
};

static PROLONG_MULTIPLIER_WITH_RELAXED_PRECISION: Module = Module {
    name: "ProlongMultiplier+RELAXED_PRECISION",
    entry: "ProlongMultiplier",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15944, bytes: 16184 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/prolong_multiplier.compute",
    hash: "ace3c7e714c3647fa546ef7ae62b6bc3bc15cfc605bbc40f4942ef2879a78116",
};
