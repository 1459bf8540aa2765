// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/apply_pressure.compute.
//! Kernels of `solver/dfsph/apply_pressure.compute`.

use super::{
    ListHead, PrecisionKeyword, PressureFactors, SmoothingKernelParams, StepParams, StepState, Velocity, WallsKeyword,
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
    hash: "eef15b3c96c2851a5034c391a1803ac1c5c4f3e1217f583405cce2cfbb81d655",
};

static APPLY_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "ApplyPressure+RELAXED_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8356, bytes: 7804 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "3946cd68e362a7abb47040cea3bec1c974bd69ac05364dda335e6ad2f99e2d5f",
};

static APPLY_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "ApplyPressure+HALF_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 16160, bytes: 7884 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "95285c416fbe578ff3196b75146e9e8d4b752169fb5e90da1b85494c3b9df29b",
};

static APPLY_PRESSURE_WITH_WALLS: Module = Module {
    name: "ApplyPressure+WALLS",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 24044, bytes: 12112 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "e526898daa375a375faea65e116ab29b3c8efe29211c19fe13da6bd645f6a4ef",
};

static APPLY_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ApplyPressure+WALLS+RELAXED_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 36156, bytes: 11508 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "1b7efe4aa1eee071f02ce7f2b637f15c815d7072dda66ed0bcb67eb4170f08b7",
};

static APPLY_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ApplyPressure+WALLS+HALF_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 47664, bytes: 11604 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "492a8cae2ce80f28b68c5795713d2cf5f882b87a636d1da93ee4fcddf0b0d1d9",
};

static APPLY_PRESSURE_WITH_SOLID_WALLS: Module = Module {
    name: "ApplyPressure+SOLID_WALLS",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 59268, bytes: 13604 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "775540c04ff9f4d99eb7a88c02fa18d9a24a842dd9f8334293f9a4b58924ad67",
};

static APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ApplyPressure+SOLID_WALLS+RELAXED_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 72872, bytes: 13000 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "a14df8a41217980468aacf781720824dab908a26da4610109df213ce918539a9",
};

static APPLY_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ApplyPressure+SOLID_WALLS+HALF_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 85872, bytes: 13096 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "182a0cf68fcd170f4cb8b90e8a9f05a646cf0eb33001be89f5b7f92bdfacff6f",
};
