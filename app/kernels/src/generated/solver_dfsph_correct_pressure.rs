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
    hash: "6e8863e6860a58c2891352b6e290a44585e1e1c00f72f699613eb09b0153b6d4",
};

static CORRECT_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10400, bytes: 9848 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "f01a7f8ad9557bc86cab72431c5e4646a46c184310b0ddbeeb814647bd7f22ab",
};

static CORRECT_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20248, bytes: 9928 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "8cd970a1c2f4311fe5301542b8d6411f777e188969ca5076544b0822c8615908",
};

static CORRECT_PRESSURE_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30176, bytes: 11360 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "7f8809b30ce1e552477308312c227c8fd1cf73d416b7e46b711e9d19cdf1a791",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 41536, bytes: 10808 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "7632a4428aa8a34a8d600efd8eae6ef8e5059e062a9273547121c095d7440636",
};

static CORRECT_PRESSURE_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 52344, bytes: 10888 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "468c5a127c3d77d3a4dd80d7d562bb0ffff24bb19b14447764fc43faafaeafc4",
};

static CORRECT_PRESSURE_WITH_WALLS: Module = Module {
    name: "CorrectPressure+WALLS",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 63232, bytes: 13612 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "5fc581ed7e93f0b72e879dfdf683908cae76e08fb8f70066f4c15dbf5ae59377",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 76844, bytes: 13008 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "4fac31deda5774371754cca208bc6e566a6342144ac82d03479969d6cd0f6ea3",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 89852, bytes: 13104 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "c8d9f5e6b7f0314191ad5aeebe42c40297a41987ac97b3d4ac34bfeca471448e",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 102956, bytes: 14572 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "5d5865fd213d57bd2626bad7a9e6e615b795f4cb316c324467b77f489fcb39c1",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 117528, bytes: 13968 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "36edaec407255ac3b1fd284ba86ccb67d79e939b23a6eeafb25c2125d425fa5b",
};

static CORRECT_PRESSURE_WITH_WALLS_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+WALLS+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 131496, bytes: 14064 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "376abaab36fe573478f749b53e476647d692e41a28915eeccad2b8358da18f68",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS: Module = Module {
    name: "CorrectPressure+SOLID_WALLS",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 145560, bytes: 15452 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "6737ed612bb311641f2a3b64c182e7383ea41d2c4d8c548789ee2a3988ff31a7",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 161012, bytes: 14848 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "c0fdebd4c542deb694b2cbecc9366cafdae8faad64ddf645f68d7d7752a32e84",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 175860, bytes: 14944 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "d4d9d8c7e2b30da1f9be3164c9e01486d5f12c3df0925b86b35d7962fafcb2ea",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+MEASURED",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 190804, bytes: 16428 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "9c0c20aa029f66448b43474b77858f893d1a4a5fe0fc44dc1e37416227c7e7d7",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+MEASURED+RELAXED_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 207232, bytes: 15824 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "4e3fcb1f0dd509c24cd64119c10ffe20bcbe6ee106e562b0edf84d39425a0a78",
};

static CORRECT_PRESSURE_WITH_SOLID_WALLS_WITH_MEASURED_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPressure+SOLID_WALLS+MEASURED+HALF_PRECISION",
    entry: "CorrectPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 223056, bytes: 15920 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Desktop,
    source: "solver/dfsph/correct_pressure.compute",
    hash: "b46da7782a786f2b4657965d0693a9c10535811fc474225551c750269d073395",
};
