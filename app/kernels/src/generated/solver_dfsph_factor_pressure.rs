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
    hash: "98a817a2ae7d9b0a87e01f05f68f8e4ff8a03c44e96843c63a150c13e6a4d27c",
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
    hash: "396eba87c75a6cf3020ce3050c2145eadf923ac6bdb42797be46d89d9b98d44e",
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
    hash: "becb993cd64858ec2e710bf3bb8318caef0bf5e2a5c0873d06b5418f74e69b93",
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
    hash: "a460989a686b88152bb1b7203d1d10a537958c1bc08875dd00041bd2a6ac6332",
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
    hash: "2abdfb01e1cbd622dad97a1953ed4ebe2b27b07a366aa0a98e3d8a9db82ec5f6",
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
    hash: "e271abe51ca1101609653bd5586697c89fe9a44ae592cc3022f8752deb575290",
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
    hash: "830121fba3c3e61a5e344f179676efeacfd7bb69936b05cd5dc44b419fbf11cf",
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
    hash: "a14ad1ebdcf61baf0bd94eda14131fcb377ff2e7e2d78f078fd23c50cbd9d049",
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
    hash: "58dca27a72d74fa52ba3d942b25391d7898c04e9c232d3f075a2d20957d4cb22",
};
