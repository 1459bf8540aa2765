// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/start_warm.compute.
//! Kernels of `solver/pbf/start_warm.compute`.

use super::{
    CellSlot, PbfParams, Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, StepParams, StepState,
    WarmStart,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`StartWarm`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct StartWarmVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// Begins a substep with a share of the last one's pressure: particles move by what it accelerated them by, and their
/// multipliers by as much of it, so that the iterations have less to find. At most .3 of it: with all of it slow modes grow.
/// After the list is made, which so is of the same positions for both particles of a pair.
#[derive(Debug)]
pub struct StartWarm<'a> {
    /// Its variant.
    pub variant: StartWarmVariant,
    /// As they were before the sort.
    ///
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<WarmStart> warm_starts`.
    pub warm_starts: Buf<'a, WarmStart>,
    /// `StructuredBuffer<CellSlot> cell_slots`.
    pub cell_slots: Buf<'a, CellSlot>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: BufMut<'a, [u32; 2]>,
    /// What stands before the first iteration.
    ///
    /// `RWStructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: Option<BufMut<'a, PositionLambda>>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
    /// `RWStructuredBuffer<uint2> packed_position_lambdas`.
    pub packed_position_lambdas: Option<BufMut<'a, [u32; 2]>>,
    /// `RWStructuredBuffer<float> lambda_totals`.
    pub lambda_totals: Option<BufMut<'a, f32>>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Option<Uniform<'a, StepParams>>,
}

impl Kernel for StartWarm<'_> {
    const STAGE: &'static str = "start_warm";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.precision) {
            (false, PrecisionKeyword::Off) => &START_WARM,
            (false, PrecisionKeyword::RelaxedPrecision) => &START_WARM_WITH_RELAXED_PRECISION,
            (false, PrecisionKeyword::HalfPrecision) => &START_WARM_WITH_RELAXED_PRECISION,
            (true, PrecisionKeyword::Off) => &START_WARM_WITH_WALLS,
            (true, PrecisionKeyword::RelaxedPrecision) => &START_WARM_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, PrecisionKeyword::HalfPrecision) => &START_WARM_WITH_WALLS_WITH_RELAXED_PRECISION,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("warm_starts", Some(self.warm_starts.id)),
                ("cell_slots", Some(self.cell_slots.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("position_lambdas", self.position_lambdas.as_ref().map(|bound| bound.id)),
                ("step_state", Some(self.step_state.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
                ("packed_position_lambdas", self.packed_position_lambdas.as_ref().map(|bound| bound.id)),
                ("lambda_totals", self.lambda_totals.as_ref().map(|bound| bound.id)),
                ("step_params", self.step_params.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &START_WARM,
    &START_WARM_WITH_RELAXED_PRECISION,
    &START_WARM_WITH_WALLS,
    &START_WARM_WITH_WALLS_WITH_RELAXED_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "warm_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "position_lambdas",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 8, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "warm_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
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
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "warm_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
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

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "warm_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
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
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_start_warm.deflate"));

static START_WARM: Module = Module {
    name: "StartWarm",
    entry: "StartWarm",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 6524 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/start_warm.compute",
    hash: "106628e366533642b4ccbf2c009da213f0e2efd1a1673bc28a791163c6509c84",
};

static START_WARM_WITH_RELAXED_PRECISION: Module = Module {
    name: "StartWarm+RELAXED_PRECISION",
    entry: "StartWarm",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 6524, bytes: 6700 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/start_warm.compute",
    hash: "756891926dc87f76a796750728907ce8adc36e501cfd64227bb363eb3e0681bf",
};

static START_WARM_WITH_WALLS: Module = Module {
    name: "StartWarm+WALLS",
    entry: "StartWarm",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 13224, bytes: 7532 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/start_warm.compute",
    hash: "b9f80ec8819c4463c79981e0e9ccc7bea301d0f399c4033b3a15ab0e6f53d2c3",
};

static START_WARM_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "StartWarm+WALLS+RELAXED_PRECISION",
    entry: "StartWarm",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20756, bytes: 7692 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/start_warm.compute",
    hash: "a8e7684fada505db37cc24cbf7767f7aec878f687a7abc4c1749803fb5264881",
};
