// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/factor_pressure.compute.
//! Kernels of `solver/dfsph/factor_pressure.compute`.

use super::{ListHead, Position, PrecisionKeyword, PressureFactors, SmoothingKernelParams, StepParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`FactorPressure`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FactorPressureVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// Density ratio and stiffness of each particle where it is: what the iterations of both solves need again and again
/// (Bender & Koschier 2017, eq. 9: the stiffness is 1/alpha, in density ratios and units of h). Particles go on in sorted order.
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
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
}

impl Kernel for FactorPressure<'_> {
    const STAGE: &'static str = "factor_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.precision) {
            (false, PrecisionKeyword::Off) => &FACTOR_PRESSURE,
            (false, PrecisionKeyword::RelaxedPrecision) => &FACTOR_PRESSURE_WITH_RELAXED_PRECISION,
            (false, PrecisionKeyword::HalfPrecision) => &FACTOR_PRESSURE_WITH_HALF_PRECISION,
            (true, PrecisionKeyword::Off) => &FACTOR_PRESSURE_WITH_WALLS,
            (true, PrecisionKeyword::RelaxedPrecision) => &FACTOR_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, PrecisionKeyword::HalfPrecision) => &FACTOR_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
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
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
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
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_factor_pressure.deflate"));

static FACTOR_PRESSURE: Module = Module {
    name: "FactorPressure",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 9564 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "2494e6943555ba7ee025a80a98e3332ce420c384376049804e096f9887a8f542",
};

static FACTOR_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 9564, bytes: 9204 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "ff9a036ec96e3f5e9fbce318ab75071643b50d45f84b3284cfa2215a508e4eca",
};

static FACTOR_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 18768, bytes: 9156 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "7b8fc9e1de6068aed060dfde4ed4893863f0fcbfd72629f6b77dea07f42ec9e5",
};

static FACTOR_PRESSURE_WITH_WALLS: Module = Module {
    name: "FactorPressure+WALLS",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 27924, bytes: 13440 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "a5f0540fe9052f37e60408f3c961d8e6fa99cae3521d9aab4e75ad24027dcab2",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 41364, bytes: 13124 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "d8a2126b6bbfb927f5985cd86bc5204ec4f0c70efb0868fa3031be93bdd49181",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 54488, bytes: 13028 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "89d99c80a619e0366576b841027dbe4d99e2b86650ec62fa9a21d2db259c6266",
};
