// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/apply_pressure.compute.
//! Kernels of `solver/dfsph/apply_pressure.compute`.

use super::{
    ListHead, PrecisionKeyword, PressureFactors, PressureSolve, SmoothingKernelParams, SolidContact, StepParams,
    StepState, Velocity, WallsKeyword,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ApplyPressure`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ApplyPressureVariant {
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// The second half of an iteration of a pressure solve: velocities, or displacements a second, take what pressures changed by.
/// Pairs take the sum of their two, so that momentum is kept, and so do a particle and its neighbours' images in the walls.
#[derive(Debug)]
pub struct ApplyPressure<'a> {
    /// Its variant.
    pub variant: ApplyPressureVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `StructuredBuffer<float> pressure_changes`.
    pub pressure_changes: Buf<'a, f32>,
    /// `RWStructuredBuffer<float> pressures`.
    pub pressures: BufMut<'a, f32>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `StructuredBuffer<PressureFactors> pressure_factors`.
    pub pressure_factors: Option<Buf<'a, PressureFactors>>,
    /// `RWStructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Option<BufMut<'a, SolidContact>>,
    /// `ConstantBuffer<PressureSolve> solve`.
    pub solve: Option<Uniform<'a, PressureSolve>>,
}

impl Kernel for ApplyPressure<'_> {
    const STAGE: &'static str = "apply_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.precision) {
            (WallsKeyword::Off, PrecisionKeyword::Off) => &APPLY_PRESSURE,
            (WallsKeyword::Off, PrecisionKeyword::RelaxedPrecision) => &APPLY_PRESSURE_WITH_RELAXED_PRECISION,
            (WallsKeyword::Off, PrecisionKeyword::HalfPrecision) => &APPLY_PRESSURE_WITH_HALF_PRECISION,
            (WallsKeyword::Walls, PrecisionKeyword::Off) => &APPLY_PRESSURE_WITH_WALLS,
            (WallsKeyword::Walls, PrecisionKeyword::RelaxedPrecision) => {
                &APPLY_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, PrecisionKeyword::HalfPrecision) => &APPLY_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
            (WallsKeyword::SolidWalls, PrecisionKeyword::Off) => &APPLY_PRESSURE_WITH_SOLID_WALLS,
            (WallsKeyword::SolidWalls, PrecisionKeyword::RelaxedPrecision) => {
                &APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, PrecisionKeyword::HalfPrecision) => {
                &APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION
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
                ("pressure_changes", Some(self.pressure_changes.id)),
                ("pressures", Some(self.pressures.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pressure_factors", self.pressure_factors.as_ref().map(|bound| bound.id)),
                ("solid_contacts", self.solid_contacts.as_ref().map(|bound| bound.id)),
                ("solve", self.solve.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &APPLY_PRESSURE,
    &APPLY_PRESSURE_WITH_RELAXED_PRECISION,
    &APPLY_PRESSURE_WITH_HALF_PRECISION,
    &APPLY_PRESSURE_WITH_WALLS,
    &APPLY_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION,
    &APPLY_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
    &APPLY_PRESSURE_WITH_SOLID_WALLS,
    &APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION,
    &APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION,
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
        name: "pressure_changes",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "pressures",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "velocities",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
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
        name: "pressure_factors",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo {
        name: "pressure_changes",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "pressures",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "velocities",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
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
        name: "pressure_factors",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo {
        name: "pressure_changes",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "pressures",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "velocities",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "solid_contacts",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solve", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_apply_pressure.deflate"));

static APPLY_PRESSURE: Module = Module {
    name: "ApplyPressure",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 8356 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "e6f26e9b87ceb656163ae78f3385136fbb225e01bd6599e85e1c1d3c678cbf5c",
};

static APPLY_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "ApplyPressure+RELAXED_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8356, bytes: 8220 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "57568187d5888829471ad1b410ea97023456b3544ee302933b21771ced90b8fc",
};

static APPLY_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "ApplyPressure+HALF_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 16576, bytes: 8300 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "25f5628c9cc361f90703e7ae3ab8682af2f62f03c87af214c8292e9052e050d9",
};

static APPLY_PRESSURE_WITH_WALLS: Module = Module {
    name: "ApplyPressure+WALLS",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 24876, bytes: 12112 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "a6fd0c36fb78c113f8feecc513245169fd333efa37f51aa51076442fbf63ee13",
};

static APPLY_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ApplyPressure+WALLS+RELAXED_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 36988, bytes: 12004 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "558a0c5727684bea1cea69a29072ae2dec27b1d6bb6788344d41523cdb1da388",
};

static APPLY_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ApplyPressure+WALLS+HALF_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 48992, bytes: 12100 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "6fba81f4c6a2080f5ed786df78be6f8a551d641cabc2978cfc212aded129ded5",
};

static APPLY_PRESSURE_WITH_SOLID_WALLS: Module = Module {
    name: "ApplyPressure+SOLID_WALLS",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 61092, bytes: 15760 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "9bf42ed0ca93f05aefbbd0cfb65c05ee9a674708b6604f961fae41eec9e77cc5",
};

static APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ApplyPressure+SOLID_WALLS+RELAXED_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 76852, bytes: 15652 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "79613b99531c863010a6484175e275718b286873313f9485748315abd02f3ae4",
};

static APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ApplyPressure+SOLID_WALLS+HALF_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 92504, bytes: 15748 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "e4c01055a8cb7e05595be525729b7610717a307290f1540f2efb06c2d5a2f9bb",
};
