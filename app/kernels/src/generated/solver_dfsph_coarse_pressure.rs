// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/coarse_pressure.compute.
//! Kernels of `solver/dfsph/coarse_pressure.compute`.

use super::{CoarseCell, CoarseGridParams, Position, PressureFactors, PressureSolve, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The two ends of the divergence solve's coarse correction: what the first iteration leaves over goes to cells of 2 h, and
/// the pressure that takes it out there comes back, beside the iteration's own. Between them PBF's stages solve for it
/// (solver/pbf/coarse\_correction.hlsli): a pressure that varies slowly changes the density by M^2 times its Laplacian in both.
/// Pressures last from substep to substep, so a share of it is enough, and it may take away, too.
#[derive(Debug)]
pub struct RestrictPressure<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<PressureFactors> pressure_factors`.
    pub pressure_factors: Buf<'a, PressureFactors>,
    /// `RWStructuredBuffer<float> pressure_changes`.
    pub pressure_changes: BufMut<'a, f32>,
    /// `RWStructuredBuffer<CoarseCell> coarse_cells`.
    pub coarse_cells: BufMut<'a, CoarseCell>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<PressureSolve> solve`.
    pub solve: Uniform<'a, PressureSolve>,
    /// `ConstantBuffer<CoarseGridParams> coarse`.
    pub coarse: Uniform<'a, CoarseGridParams>,
}

impl Kernel for RestrictPressure<'_> {
    const STAGE: &'static str = "restrict_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &RESTRICT_PRESSURE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("pressure_factors", Some(self.pressure_factors.id)),
                ("pressure_changes", Some(self.pressure_changes.id)),
                ("coarse_cells", Some(self.coarse_cells.id)),
                ("step_state", Some(self.step_state.id)),
                ("solve", Some(self.solve.id)),
                ("coarse", Some(self.coarse.id)),
            ],
        )
    }
}

/// The two ends of the divergence solve's coarse correction: what the first iteration leaves over goes to cells of 2 h, and
/// the pressure that takes it out there comes back, beside the iteration's own. Between them PBF's stages solve for it
/// (solver/pbf/coarse\_correction.hlsli): a pressure that varies slowly changes the density by M^2 times its Laplacian in both.
/// Pressures last from substep to substep, so a share of it is enough, and it may take away, too.
#[derive(Debug)]
pub struct ProlongPressure<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<float> pressures`.
    pub pressures: Buf<'a, f32>,
    /// `StructuredBuffer<float> multipliers`.
    pub multipliers: Buf<'a, f32>,
    /// `RWStructuredBuffer<float> pressure_changes`.
    pub pressure_changes: BufMut<'a, f32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<CoarseGridParams> coarse`.
    pub coarse: Uniform<'a, CoarseGridParams>,
}

impl Kernel for ProlongPressure<'_> {
    const STAGE: &'static str = "prolong_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &PROLONG_PRESSURE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("pressures", Some(self.pressures.id)),
                ("multipliers", Some(self.multipliers.id)),
                ("pressure_changes", Some(self.pressure_changes.id)),
                ("step_state", Some(self.step_state.id)),
                ("coarse", Some(self.coarse.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&RESTRICT_PRESSURE, &PROLONG_PRESSURE];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "pressure_factors",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo {
        name: "pressure_changes",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "coarse_cells",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solve", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "coarse", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "pressures", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "multipliers", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "pressure_changes",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "coarse", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_coarse_pressure.deflate"));

static RESTRICT_PRESSURE: Module = Module {
    name: "RestrictPressure",
    entry: "RestrictPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 6008 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/coarse_pressure.compute",
    hash: "7c56dcd865ad28e4270397eac2479f8e188f3fed407c6729039437979c44861c",
};

static PROLONG_PRESSURE: Module = Module {
    name: "ProlongPressure",
    entry: "ProlongPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 6008, bytes: 15600 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/coarse_pressure.compute",
    hash: "6971ed7d1c87f8487c9b854afc2f978f388c640808d1176645b9dc5b540de73d",
};
