// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/factor_pressure.compute.
//! Kernels of `solver/dfsph/factor_pressure.compute`.

use super::{
    ListHead, Position, PrecisionKeyword, PressureFactors, SmoothingKernelParams, StepParams, StepState, Velocity,
};
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
                ("shifts", Some(self.shifts.id)),
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
    BindingInfo { name: "shifts", slot: 6, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 } },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_factor_pressure.deflate"));

static FACTOR_PRESSURE: Module = Module {
    name: "FactorPressure",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 13120 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "a704df75280211daa22373c688a80f9b2524649efafe1e251b8b45cc1f4dcbdb",
};

static FACTOR_PRESSURE_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 13120, bytes: 12676 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "0acff6498a8e8755d88a364b7322d54d3ae50c4a37cc77e59379e9c444224715",
};

static FACTOR_PRESSURE_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 25796, bytes: 12628 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "089bc5ed7cb00acd30f37b4bf00dbe3ead26e676939fb389dce1b0faa81b3ba7",
};

static FACTOR_PRESSURE_WITH_WALLS: Module = Module {
    name: "FactorPressure+WALLS",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 38424, bytes: 17268 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "fcb8ed8b7762ede8dccf4ec1f22d32be7e19e45d6d4380c0f6dbe05a66047948",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+RELAXED_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 55692, bytes: 16868 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "26bd9bebbc5c42cc6d7cb4da42e7c41e689c63f4ad1a30c0ae8218e2ba125928",
};

static FACTOR_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "FactorPressure+WALLS+HALF_PRECISION",
    entry: "FactorPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 72560, bytes: 16772 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/factor_pressure.compute",
    hash: "dc38ef625b7ab2aae9e4cb1235337eb9f7e65ea23b0a753536eb60e21b428188",
};
