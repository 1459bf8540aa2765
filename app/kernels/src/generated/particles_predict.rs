// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/predict.compute.
//! Kernels of `particles/predict.compute`.

use super::{Counters, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`Predict`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct PredictVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// Predicts where each particle would go without its neighbours: v += g dt, x += v dt
/// (Macklin & Muller 2013, algorithm 1, lines 1-4), and keeps it inside the walls and periods.
#[derive(Debug)]
pub struct Predict<'a> {
    /// Its variant.
    pub variant: PredictVariant,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
}

impl Kernel for Predict<'_> {
    const STAGE: &'static str = "predict";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.periodic) {
            (false, false) => &PREDICT,
            (false, true) => &PREDICT_WITH_PERIODIC,
            (true, false) => &PREDICT_WITH_WALLS,
            (true, true) => &PREDICT_WITH_WALLS_WITH_PERIODIC,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&PREDICT, &PREDICT_WITH_PERIODIC, &PREDICT_WITH_WALLS, &PREDICT_WITH_WALLS_WITH_PERIODIC];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "counters",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
];

static PREDICT: Module = Module {
    name: "Predict",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/predict.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "cd1f2c2677a226688a301bd61cd5a3523acef634ed6cdaf0ddb3af6f156a856c",
};

static PREDICT_WITH_PERIODIC: Module = Module {
    name: "Predict+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/predict+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "c497a23cfdad0db61cee2f49876816218f21f0b585da3e7cb01942b6961e115e",
};

static PREDICT_WITH_WALLS: Module = Module {
    name: "Predict+WALLS",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/predict+walls.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "9d84a8367f27821282b53c17461543c37bea8ab31a7c67e75d52aab931d09dec",
};

static PREDICT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Predict+WALLS+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/predict+walls+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "6bc952758d1b4345ca3f7535f106a7e9c4c2ef568c7a9dcfd4accbfc3ad7cabc",
};
