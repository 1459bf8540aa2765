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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5392 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "353b4a1f38ecc07e4916fb27fd4f3a37b7de034ff68844153b2de82c4d82f38d",
};

static PREDICT_WITH_PERIODIC: Module = Module {
    name: "Predict+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5392, bytes: 6360 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "5edaa74f1432a85270cd64178c7d1ee5b07381cf8a98d22e9954e15a78345915",
};

static PREDICT_WITH_WALLS: Module = Module {
    name: "Predict+WALLS",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 11752, bytes: 5876 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "15184f4ea3ebbe2b2915d3af45fc0cf44dea9256eb1f7c45bef020a284f6ff1a",
};

static PREDICT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Predict+WALLS+PERIODIC",
    entry: "Predict",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17628, bytes: 6844 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/predict.compute",
    hash: "6abe8b9943cb6f8279077fe6b286cf9cbe0169d86c8554a91e9e16392c5f0be4",
};
