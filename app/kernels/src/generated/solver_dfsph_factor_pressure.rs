// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/factor_pressure.compute.
//! Kernels of `solver/dfsph/factor_pressure.compute`.

use super::{
    ListHead, Position, PrecisionKeyword, PressureFactors, SmoothingKernelParams, SolidContact, StepParams, StepState,
    Velocity, WallsKeyword,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`FactorPressure`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FactorPressureVariant {
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// Density ratio and stiffness of each particle where it is: what the iterations of both solves need again and again
/// (Bender & Koschier 2017, eq. 9: the stiffness is 1/alpha, in density ratios and units of h). Particles go on in sorted order.
/// Displacements begin with what parts pairs that are too close: at one point they are neither compressed nor have a slope.
#[derive(Debug)]
pub struct FactorPressure<'a> {
    /// Its variant.
    pub variant: FactorPressureVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<PressureFactors> pressure_factors`.
    pub pressure_factors: BufMut<'a, PressureFactors>,
    /// displacements over dt
    ///
    /// `RWStructuredBuffer<Velocity> shifts`.
    pub shifts: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `StructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Option<Buf<'a, SolidContact>>,
}

impl Kernel for FactorPressure<'_> {
    const STAGE: &'static str = "factor_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.precision) {
            (WallsKeyword::Off, PrecisionKeyword::Off) => &FACTOR_PRESSURE,
            (WallsKeyword::Off, PrecisionKeyword::RelaxedPrecision) => &FACTOR_PRESSURE_WITH_RELAXED_PRECISION,
            (WallsKeyword::Off, PrecisionKeyword::HalfPrecision) => &FACTOR_PRESSURE_WITH_HALF_PRECISION,
            (WallsKeyword::Walls, PrecisionKeyword::Off) => &FACTOR_PRESSURE_WITH_WALLS,
            (WallsKeyword::Walls, PrecisionKeyword::RelaxedPrecision) => {
                &FACTOR_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, PrecisionKeyword::HalfPrecision) => &FACTOR_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
            (WallsKeyword::SolidWalls, PrecisionKeyword::Off) => &FACTOR_PRESSURE_WITH_SOLID_WALLS,
            (WallsKeyword::SolidWalls, PrecisionKeyword::RelaxedPrecision) => {
                &FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, PrecisionKeyword::HalfPrecision) => {
                &FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("positions", Some(self.positions.id)),
                ("pressure_factors", Some(self.pressure_factors.id)),
                ("shifts", Some(self.shifts.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("solid_contacts", self.solid_contacts.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &FACTOR_PRESSURE,
    &FACTOR_PRESSURE_WITH_RELAXED_PRECISION,
    &FACTOR_PRESSURE_WITH_HALF_PRECISION,
    &FACTOR_PRESSURE_WITH_WALLS,
    &FACTOR_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION,
    &FACTOR_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
    &FACTOR_PRESSURE_WITH_SOLID_WALLS,
    &FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION,
    &FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION,
];

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
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "pressure_factors",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "shifts", slot: 6, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 } },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
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
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "pressure_factors",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "shifts", slot: 7, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 } },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_factor_pressure.deflate"));

static FACTOR_PRESSURE: Module = Module {
    name: "FactorPressure",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 13128 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "143dd8d9395c9bce69ed6d7d8a0dfb5489ad8c0b8e3271e44854aa586aeea0b6",
};

static FACTOR_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 13128, bytes: 13180 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "8c36632f3e1621b929b6ec605f12b412c3c03cc09bebc3752e6bd44b19c4f1c4",
};

static FACTOR_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 26308, bytes: 13132 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "d069602dbb838cda550ede70f1de967c9e4b1470d663827ca2196e5ac144f0ca",
};

static FACTOR_PRESSURE_WITH_WALLS: Module = Module {
    name: "FactorPressure+WALLS",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 39440, bytes: 17276 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "1b44c6c53ce403444d955cfe5c63ea0d30b2f9c4b2cc8264cdbc3af29f8c1724",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 56716, bytes: 17452 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "90bc38c3faba345ff20aafa81d315050356b267ce127992395e5c75c933e2152",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 74168, bytes: 17356 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "21b52726f2eb5640fa1caa57f38996732e0f907b8eacad32d67a28d7f075312a",
};

static FACTOR_PRESSURE_WITH_SOLID_WALLS: Module = Module {
    name: "FactorPressure+SOLID_WALLS",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 91524, bytes: 20672 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "569297f62081e34bc28159c67d480163fd035d4330cfc413846812db2947181c",
};

static FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+SOLID_WALLS+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 112196, bytes: 20848 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "371b60eb1a42cf369d9b4080cd95d0788a29d303eae9bde520ceac6a32584329",
};

static FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+SOLID_WALLS+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 133044, bytes: 20752 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "fdc084013874e55a21b456c2b38a6992076ac9a074bafa3586604d4de426eb82",
};
