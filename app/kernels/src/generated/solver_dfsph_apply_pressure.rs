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
    hash: "37c027cae13bb74b8b49211851225b1b5d25a746f3f850b01be3eb05ede2eaf3",
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
    hash: "3481e1e5dbfb900ff85094b5d47925f49c1c59f1bae8d93b656965f9b5f9b9ab",
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
    hash: "bbf842f764231946c929295025b5028d090f258ee23ed7559e46f99827a5f173",
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
    hash: "2787ab884b50ca8cf20e9353c4aa58d04890c478497a5799b7900fa55c74abe3",
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
    hash: "d8f872e25895e090f6bfa8451eb3c95e7eb6961c23188ffcc3ddacde84e7b56c",
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
    hash: "5dce40e6ee249512c9d645f5acacd186ac5b68b4b74c538b3edd2af4ba3aed5d",
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
    hash: "434fbbb18d8112ba3be94fa7c52165cfabf12796f4828b5ce9e87e324142fbc8",
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
    hash: "0a7ab79e270d02716c3e79bb97b8ca611c24bd0e576f754b48a2fcc67a7b3026",
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
    hash: "793683b74b29171345dff3f43a2689a2c321bf7478a4869acbcfe8c12b5d8ab4",
};
