// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/correct_pressure.compute.
//! Kernels of `solver/dfsph/correct_pressure.compute`.

use super::{
    ListHead, PrecisionKeyword, PressureFactors, PressureSolve, SmoothingKernelParams, StepParams, StepState, Velocity,
    WallsKeyword,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`CorrectPressure`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CorrectPressureVariant {
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
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
            (WallsKeyword::Off, false, PrecisionKeyword::Off) => &CORRECT_PRESSURE,
            (WallsKeyword::Off, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_PRESSURE_WITH_RELAXED_PRECISION,
            (WallsKeyword::Off, false, PrecisionKeyword::HalfPrecision) => &CORRECT_PRESSURE_WITH_HALF_PRECISION,
            (WallsKeyword::Off, true, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_MEASURED,
            (WallsKeyword::Off, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_PRESSURE_WITH_MEASURED_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_PRESSURE_WITH_MEASURED_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_WALLS,
            (WallsKeyword::Walls, false, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED,
            (WallsKeyword::Walls, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, false, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_SOLID_WALLS,
            (WallsKeyword::SolidWalls, false, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, false, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, true, PrecisionKeyword::Off) => &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED,
            (WallsKeyword::SolidWalls, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_HALF_PRECISION
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
    &CORRECT_PRESSURE_WITH_SOLID_WALLS,
    &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION,
    &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION,
    &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED,
    &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION,
    &CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_HALF_PRECISION,
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
    BindingInfo { name: "solve", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
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
    BindingInfo { name: "solve", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_correct_pressure.deflate"));

static CORRECT_PRESSURE: Module = Module {
    name: "CorrectPressure",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10400 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "604759545cf4ef5660c58e2977d3315593f59abbf7d3199ad42197bd7a79f819",
};

static CORRECT_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10400, bytes: 10264 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "f5f07fcfe871bc5cf1ab13406833fb0e80cc22fb1de889109a0834cc4f781a68",
};

static CORRECT_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20664, bytes: 10344 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "fa4621f5fdc5350f3fe05de7c2102a8f564972c024328f285423a53a59357f42",
};

static CORRECT_PRESSURE_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 31008, bytes: 11360 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "bc9368c280a4159ec53d1366d0aa5d6afeb3346b2d6505138a502728b4bd5f12",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42368, bytes: 11224 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "752919be8f8d9272ebc1b282426ac143dc57e203fe903cd46dce8cab0e911d86",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 53592, bytes: 11304 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "96bb5f71ba2ecfbcf9b66174def77e17274021f86b47bcfd12fca1e01b5c6c5b",
};

static CORRECT_PRESSURE_WITH_WALLS: Module = Module {
    name: "CorrectPressure+WALLS",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 64896, bytes: 13612 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "3ba3e5edf6abd02d151e5d9adf2705c9c535e30253622870eeb705c2d89d48e7",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 78508, bytes: 13504 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "512331a9ebd23b3c1120fb4231601c45e431189d025173582e98dad7d7716614",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 92012, bytes: 13600 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "24c1416c95f5e6f7bcf1a7f2f48517d5b0596f94c0a54a46de32e2461a7bf9cd",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 105612, bytes: 14572 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "aee1f4eecede4a0ec2a7fb75bd26349ee07d893a90708cb831a1b56131f37bce",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 120184, bytes: 14464 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "0514f8fab6e221932dcb0066fc8ecbfcb868371fc4bf2f3f57679e6985193096",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 134648, bytes: 14560 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "3034e502d8b0fd9929e35df85f6b39a449799a686c1efdcfdc61005b4ad60b96",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS: Module = Module {
    name: "CorrectPressure+SOLID_WALLS",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 149208, bytes: 15452 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "72e00382e51c0053c5941b36113b7dcd136154f54c7ac022195b2743692c49c2",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 164660, bytes: 15344 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "2f4cc00c8f858a50c4a516703c54ae3417da50d15dfe745ceba53c00bb5444f6",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 180004, bytes: 15440 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "91629e14cdf0a39e2e5eb10d3de06a981f4ac8573880aa77f45c485a907f5ee8",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 195444, bytes: 16428 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "d542ac7793a2272612b06a9de60fc25a648517c823f09ebeb5d4901761751d33",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 211872, bytes: 16320 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "6830019514d183775846e4eedc1c81b2cfc9a926d14cecb35300f9cf38b73119",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 228192, bytes: 16416 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "03890c7b886c801063f4aa46d2903ecd71161a7f5eef2a0d48610f4198289a94",
};
