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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_predict.deflate"));

static PREDICT: Module = Module {
    name: "Predict",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5384 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "a54cd4eeff4522c5ac6b2a2958a2038fd695c3c90b1d382952293c30ebe9c84f",
};

static PREDICT_WITH_PERIODIC: Module = Module {
    name: "Predict+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5384, bytes: 6352 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "e5f27e410bb6e4ad88c8c1bb3cf3c0750bfef969756addf8861c28a1c8b1fc9d",
};

static PREDICT_WITH_WALLS: Module = Module {
    name: "Predict+WALLS",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 11736, bytes: 5868 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "d4c7bdb3cd7e9dc0b6e56f94f6f5ce6cf5a8af77f03faec4644d4f864675ce85",
};

static PREDICT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Predict+WALLS+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17604, bytes: 6836 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "c40a6402cad4ba3c3b0787c468972601ea4b41a3490dea3d95ccf333612531ad",
};
