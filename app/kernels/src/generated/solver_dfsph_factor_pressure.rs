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
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 48 },
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
    hash: "40af6086b71b5c09b7e12b110f3d2c4a1a08a06f0f02ec7606c9ae8a76510f61",
};

static FACTOR_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 13128, bytes: 12684 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "f0affcbe674a64e5f66aa6183b8ca71a7ce01b652e4ea0c2da64f9737e028798",
};

static FACTOR_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 25812, bytes: 12636 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "e5f7190c6bf174c893dacb3f9eb51f4cddf157f1cac4ae57124de0fbbbd3b152",
};

static FACTOR_PRESSURE_WITH_WALLS: Module = Module {
    name: "FactorPressure+WALLS",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 38448, bytes: 17276 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "baa3e7225c3ab01a4faa38213620979c7b8b126b70b1f13f72b1e8ab6d5bccad",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 55724, bytes: 16876 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "f098008f628b4a80fd6d679ce4be1ae516985521fc96b03f24070675e8394250",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 72600, bytes: 16780 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "5345cb263af5808805e4d9841a473dc40cd654b816463681d39320da35ec8a02",
};

static FACTOR_PRESSURE_WITH_SOLID_WALLS: Module = Module {
    name: "FactorPressure+SOLID_WALLS",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 89380, bytes: 20580 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "626b15fe13d1c02a982b2b80bb01677f4a1219d9b7338ce905bd0e4ecf83f2a2",
};

static FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+SOLID_WALLS+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 109960, bytes: 20180 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "774bbb3e701676cb2ad079e9da75e6b6c6f2a8081d091910d0f753d57869e99b",
};

static FACTOR_PRESSURE_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+SOLID_WALLS+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 130140, bytes: 20084 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "b8e0b99b41e474b4bc1ecd6a79092663052487be1a27019af0b14ba2249dc1d3",
};
