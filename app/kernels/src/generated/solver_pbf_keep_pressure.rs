// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/keep_pressure.compute.
//! Kernels of `solver/pbf/keep_pressure.compute`.

use super::{Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, StepState, WarmStart};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`KeepPressure`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct KeepPressureVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// What the corrections of a substep came to, for the next one to begin with a share of it (start\_warm.compute).
#[derive(Debug)]
pub struct KeepPressure<'a> {
    /// Its variant.
    pub variant: KeepPressureVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: Option<Buf<'a, PositionLambda>>,
    /// `RWStructuredBuffer<WarmStart> warm_starts`.
    pub warm_starts: BufMut<'a, WarmStart>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `StructuredBuffer<uint2> packed_position_lambdas`.
    pub packed_position_lambdas: Option<Buf<'a, [u32; 2]>>,
    /// `StructuredBuffer<float> lambda_totals`.
    pub lambda_totals: Option<Buf<'a, f32>>,
}

impl Kernel for KeepPressure<'_> {
    const STAGE: &'static str = "keep_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match self.variant.precision {
            PrecisionKeyword::Off => &KEEP_PRESSURE,
            PrecisionKeyword::RelaxedPrecision => &KEEP_PRESSURE_WITH_RELAXED_PRECISION,
            PrecisionKeyword::HalfPrecision => &KEEP_PRESSURE_WITH_RELAXED_PRECISION,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("position_lambdas", self.position_lambdas.as_ref().map(|bound| bound.id)),
                ("warm_starts", Some(self.warm_starts.id)),
                ("step_state", Some(self.step_state.id)),
                ("kernel", Some(self.kernel.id)),
                ("packed_position_lambdas", self.packed_position_lambdas.as_ref().map(|bound| bound.id)),
                ("lambda_totals", self.lambda_totals.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&KEEP_PRESSURE, &KEEP_PRESSURE_WITH_RELAXED_PRECISION];

static BINDINGS_0: &[BindingInfo] = &[
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
    BindingInfo {
        name: "position_lambdas",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "warm_starts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
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
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "lambda_totals",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "warm_starts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_keep_pressure.deflate"));

static KEEP_PRESSURE: Module = Module {
    name: "KeepPressure",
    entry: "KeepPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5364 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/keep_pressure.compute",
    hash: "2421453b4ba233b552620a3f40e77a0007f2510385f2dc5d1ab536a767a1e9e1",
};

static KEEP_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "KeepPressure+RELAXED_PRECISION",
    entry: "KeepPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5364, bytes: 5720 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/keep_pressure.compute",
    hash: "30eacaab4dd8fe6d3f877e6f0b770fb8dd94c7200e7b26be2bf9800805ec7e6c",
};
