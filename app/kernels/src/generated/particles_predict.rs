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
    hash: "8a49bfc5adab5c1aa7c86496fe7021508100b185cbce412e5cb613e4504dab2d",
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
    hash: "5907b6b0601e69f193e673e0ca811f468365ffd81bf7fb7fb07b0097f6f10ef4",
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
    hash: "d724e103b5dc65499d8d5502212aa011f84fbc3a1fa8a6cb0c8c2a14b7290f81",
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
    hash: "06182bf74a6afc82873e0b33ac19958909c2a034bbc91ba6b25e9c9108db4d11",
};
