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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10392 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "dff20599f0a41f861c92348d0c6ad8c831ae341cc7d81b8b1293829b2f1e8999",
};

static CORRECT_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10392, bytes: 9840 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "14d5c1661195297e67527c0e222b608ae1b77c97faed6f66960bb536bc60f0c6",
};

static CORRECT_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20232, bytes: 9920 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "d5ca92becdd84d3b610b608cac9e942eec53f123612ebd63546d1022420ad628",
};

static CORRECT_PRESSURE_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30152, bytes: 11352 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "f508122b22a423c825cf4d216ea8a932865c765b12d80859aa2c40105a030652",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 41504, bytes: 10800 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "69695bef72b6fcd4a37a93a94f35788b4195495773d16960c6c1ca1aff04bfef",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 52304, bytes: 10880 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "b93c12fe88082fb54b5a436db16c09ed6655cea4a9c9d9787f81650cbd05008b",
};

static CORRECT_PRESSURE_WITH_WALLS: Module = Module {
    name: "CorrectPressure+WALLS",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 63184, bytes: 13604 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "f0761032a9ad6e030e24fd1ddec1e0b9a31663ef7969df6389fcf47e385a4dcb",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 76788, bytes: 13000 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "033160037d540d259aa2d190e5da79468a4f664a38ce5ac5abc7ef930a191539",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 89788, bytes: 13096 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "d98d704b8305a0bebc2d7e5d070d12a6d9de7c2e3620fdb385d2cb99cadaba19",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 102884, bytes: 14564 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "00ed6bb096fa02986952a1646c1062acf144972445cd7e3802a392186abe203f",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 117448, bytes: 13960 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "f963394027bd925cecc8872a95aafbf0725019944771e1101d6aabf9c4e36aab",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 131408, bytes: 14056 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "e120846f6075d34f144d6fb73e448264f07b1efbeb457d96751fedceba02f656",
};
