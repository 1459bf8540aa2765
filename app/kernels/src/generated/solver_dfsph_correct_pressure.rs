// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/correct_pressure.compute.
//! Kernels of `solver/dfsph/correct_pressure.compute`.

use super::{
    ListHead, PrecisionKeyword, PressureFactors, PressureSolve, SmoothingKernelParams, StepParams, StepState, Velocity,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`CorrectPressure`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CorrectPressureVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `MEASURED`.
    pub measured: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// The first half of an iteration of a pressure solve: how the density changes in a substep with the velocities that are
/// reached, and what each particle's pressure has to change by for it not to be too much (Bender & Koschier 2017, algorithms
/// 2 and 3). Relaxed Jacobi with momentum on a linear complementarity problem: a pressure is never negative, and where it is 0
/// the fluid may expand.
#[derive(Debug)]
pub struct CorrectPressure<'a> {
    /// Its variant.
    pub variant: CorrectPressureVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `StructuredBuffer<PressureFactors> pressure_factors`.
    pub pressure_factors: Buf<'a, PressureFactors>,
    /// `StructuredBuffer<float> pressures`.
    pub pressures: Buf<'a, f32>,
    /// `RWStructuredBuffer<float> pressure_changes`.
    pub pressure_changes: BufMut<'a, f32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<PressureSolve> solve`.
    pub solve: Uniform<'a, PressureSolve>,
    /// `RWStructuredBuffer<float> group_residuals`.
    pub group_residuals: Option<BufMut<'a, f32>>,
}

impl Kernel for CorrectPressure<'_> {
    const STAGE: &'static str = "correct_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.measured, self.variant.precision) {
            (false, false, PrecisionKeyword::Off) => &CORRECT_PRESSURE,
            (false, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_PRESSURE_WITH_RELAXED_PRECISION,
            (false, false, PrecisionKeyword::HalfPrecision) => &CORRECT_PRESSURE_WITH_HALF_PRECISION,
            (false, true, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_MEASURED,
            (false, true, PrecisionKeyword::RelaxedPrecision) => &CORRECT_PRESSURE_WITH_MEASURED_WITH_RELAXED_PRECISION,
            (false, true, PrecisionKeyword::HalfPrecision) => &CORRECT_PRESSURE_WITH_MEASURED_WITH_HALF_PRECISION,
            (true, false, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_WALLS,
            (true, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, false, PrecisionKeyword::HalfPrecision) => &CORRECT_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
            (true, true, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED,
            (true, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION
            }
            (true, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_HALF_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("pressure_factors", Some(self.pressure_factors.id)),
                ("pressures", Some(self.pressures.id)),
                ("pressure_changes", Some(self.pressure_changes.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("solve", Some(self.solve.id)),
                ("group_residuals", self.group_residuals.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CORRECT_PRESSURE,
    &CORRECT_PRESSURE_WITH_RELAXED_PRECISION,
    &CORRECT_PRESSURE_WITH_HALF_PRECISION,
    &CORRECT_PRESSURE_WITH_MEASURED,
    &CORRECT_PRESSURE_WITH_MEASURED_WITH_RELAXED_PRECISION,
    &CORRECT_PRESSURE_WITH_MEASURED_WITH_HALF_PRECISION,
    &CORRECT_PRESSURE_WITH_WALLS,
    &CORRECT_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION,
    &CORRECT_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
    &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED,
    &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION,
    &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_HALF_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "pressure_factors",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "pressures", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "pressure_changes",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solve", slot: 10, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "pressure_factors",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "pressures", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "pressure_changes",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "group_residuals",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solve", slot: 11, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_correct_pressure.deflate"));

static CORRECT_PRESSURE: Module = Module {
    name: "CorrectPressure",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10124 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "53ad7b9d779afa6f5295aa0c2639822b265686a711371c39482c808ab5615e45",
};

static CORRECT_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10124, bytes: 9572 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "cff1f9db2e05a8574f5e88185ec96d2bd838dd4e8c8b817c0e6bb65080d6b6f9",
};

static CORRECT_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19696, bytes: 9652 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "d16e775a3b78c2ab75ead42903bc3cb27e635f67bca01645cefaabda39c73a14",
};

static CORRECT_PRESSURE_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 29348, bytes: 11084 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "24dbb3974ab0bd823f3a4fe1e173e88bcb80a4b53bba537509de3b5e97ae84d8",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 40432, bytes: 10532 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "1d7c415eadcc108b4e32535ec0ad6fc3a56b65372c0cff7ab89be2e03cdb555d",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 50964, bytes: 10612 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "6588de7e901877bf2409265f42a37eb68f00778c07d281bda6900f37f2cc2202",
};

static CORRECT_PRESSURE_WITH_WALLS: Module = Module {
    name: "CorrectPressure+WALLS",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 61576, bytes: 13336 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "c0ae63f00c8556d7847f4beebee8095bc4ae12d1749b80922cec28b924b319d2",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 74912, bytes: 12732 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "59b8a8ca48540819fad0266a29fb078be6fe728ce1831b055b324d2bc1f03951",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 87644, bytes: 12828 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "71e34845ed84235f1525c9500a19536213c875a39a49d83b4d25b4a9e59b78df",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 100472, bytes: 14296 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "f2d59603f4e50c1a6cf72babe84e192e5bb971092b2e0a92d9f09092fcd100b8",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 114768, bytes: 13692 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "a6d4b6f841934b0582d8c99bd59fa908d4919f3222477b978b89534d4115cd02",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 128460, bytes: 13788 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "8ffbeb0f0fdc5f39e67e6268c14f508e2c9a1a2f6b4253c2bec50b5a6e628c0c",
};
