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
    hash: "87de070ee9575ee8a2fdeb0b3e395148ede95061be0be628148899b839668304",
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
    hash: "bfe59a7ced1f93218c7a6a5442134784ed214ead795759041377f3003d4cc9b9",
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
    hash: "f9d7ebff09d31d409d6695d9b13c58003e738ccdf20c1f031c2146c820fe6aa4",
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
    hash: "d1d67d347154e2f5a6436385f9d6bf872ee20a9b86ebff9cd400655ccb5160f9",
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
    hash: "c60280369b161e414a14f62ea00d650b6ae03b765800d1cec4e1ec06ed8ed2db",
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
    hash: "526de017fabaf6f1f5cc00f6aad468a41aed1d707166a729ef5974cce0ee0acc",
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
    hash: "24fd012aef9f2779ca493ac09fe231e9664a0d86997ab59cec205ff8a2dcd93e",
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
    hash: "9a86ac2649e028e1f4c7774fdb9c5aa468da2265a252a8dd832d0149aabb1330",
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
    hash: "96af0fb841b8ebda273de43e8ae6cdb921be0ee5cb9b6ac42f6996a9acb77c94",
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
    hash: "d52496d1ce2a2ab794b0b5074710cfdd59b8969a3f709ad5135767c96a17264b",
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
    hash: "b208410d8c42b14d2b930a0bc73220500cf3ad7044cf908c65b8c93f5834d540",
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
    hash: "5182850bebd799b8c2cf605fcadcc489bbdba842b4ea7804798c85b2c30bf8de",
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
    hash: "5d910504fcac0a2ad45f66fac819fe02c1e6c690b4c7516f780d13ed5ddf414c",
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
    hash: "9a15c6411db8c8151d79a7fbc37c96fca9a315d8cb8931a97f70f91782bd5a60",
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
    hash: "a55f143f16e8b55cc11485b2bce705e02c53ca00b91b74bd97c4122c90d347cc",
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
    hash: "72d8b589db9ba77b1cc0d9c65ad56074b3c2a983d446ddc1b6a20c6a0fbea04e",
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
    hash: "8abf3399b1194cd272e96b63130b28d9119bdcef8dc74fb43dd4477384545cbd",
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
    hash: "fe8e2a5bbfb282b6da06249e9247053012a6f189f441dc47dae5f219eef37223",
};
