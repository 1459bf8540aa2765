// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/predict.compute.
//! Kernels of `particles/predict.compute`.

use super::{Counters, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_predict.deflate"));

static PREDICT: Module = Module {
    name: "Predict",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5660 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "af2fd57052a1b3def5c419888caa21d0504fb254e024ebd57a58761814be7fd3",
};

static PREDICT_WITH_PERIODIC: Module = Module {
    name: "Predict+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5660, bytes: 6628 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "ff29137996429cb00e99cab2b9ec3fab52fd0a1aff1ebded6e73f4d20f6ccec9",
};

static PREDICT_WITH_WALLS: Module = Module {
    name: "Predict+WALLS",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 12288, bytes: 6144 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "cb8c41fd486bcdebc9295c746a5609b1af6303a53dc22df2a8891eb4cbbe2b8b",
};

static PREDICT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Predict+WALLS+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 18432, bytes: 7112 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "87a91c1f295940f8c47cec471dcc3f69a5e7e94adea174d5d072dd9ff45aed5e",
};
