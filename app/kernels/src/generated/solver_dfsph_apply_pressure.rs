// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/apply_pressure.compute.
//! Kernels of `solver/dfsph/apply_pressure.compute`.

use super::{ListHead, PrecisionKeyword, PressureFactors, SmoothingKernelParams, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ApplyPressure`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ApplyPressureVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
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
            (false, PrecisionKeyword::Off) => &APPLY_PRESSURE,
            (false, PrecisionKeyword::RelaxedPrecision) => &APPLY_PRESSURE_WITH_RELAXED_PRECISION,
            (false, PrecisionKeyword::HalfPrecision) => &APPLY_PRESSURE_WITH_HALF_PRECISION,
            (true, PrecisionKeyword::Off) => &APPLY_PRESSURE_WITH_WALLS,
            (true, PrecisionKeyword::RelaxedPrecision) => &APPLY_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, PrecisionKeyword::HalfPrecision) => &APPLY_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION,
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
    hash: "b836a54f84d264d0b28467ff50d12f768baeedfc8bafaf3919928ab6fdfd5634",
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
    hash: "5fde229bf499d52264e8d0259b960b9080ed1eaf2addc9ea121f5183b93bdac3",
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
    hash: "368bb469092910a6cc9b6d6913fe53be94f8816c67b93eaadeb394a2a42d3a75",
};

static APPLY_PRESSURE_WITH_WALLS: Module = Module {
    name: "ApplyPressure+WALLS",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 24044, bytes: 12072 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "e9b4bb2d94f282b8c8bba600246082400ffca01fdb284a794a735ab0fcd16a47",
};

static APPLY_PRESSURE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ApplyPressure+WALLS+RELAXED_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 36116, bytes: 11468 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "889ffa4265aec7281f202cf7c5940e257e1a2c47513545a6174d9b61bd3144ae",
};

static APPLY_PRESSURE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ApplyPressure+WALLS+HALF_PRECISION",
    entry: "ApplyPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 47584, bytes: 11564 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/dfsph/apply_pressure.compute",
    hash: "179a8dca1278d9466356b29d2c752e5535c47817238878853d6bea91308de957",
};
