// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/choose_time_step.compute.
//! Kernels of `solver/sph/choose_time_step.compute`.

use super::{Counters, SphLimits, SphTimeStep, StepParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
};

/// Which variant of [`ChooseTimeStep`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ChooseTimeStepVariant {
    /// Keyword `ADAPTIVE`.
    pub adaptive: bool,
}

/// Opens a substep: holds its dt against what the fluid allows (CFL, viscosity, force, surface tension), and counts it where
/// it is more. With ADAPTIVE it takes as few substeps to the step's end as are allowed; those left over visit nothing.
#[derive(Debug)]
pub struct ChooseTimeStep<'a> {
    /// Its variant.
    pub variant: ChooseTimeStepVariant,
    /// `RWStructuredBuffer<StepState> step_state`.
    pub step_state: BufMut<'a, StepState>,
    /// `RWStructuredBuffer<SphTimeStep> time_step`.
    pub time_step: BufMut<'a, SphTimeStep>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Option<Uniform<'a, StepParams>>,
    /// `ConstantBuffer<SphLimits> limits`.
    pub limits: Uniform<'a, SphLimits>,
}

impl Kernel for ChooseTimeStep<'_> {
    const STAGE: &'static str = "choose_time_step";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.adaptive { &CHOOSE_TIME_STEP_WITH_ADAPTIVE } else { &CHOOSE_TIME_STEP }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("step_state", Some(self.step_state.id)),
                ("time_step", Some(self.time_step.id)),
                ("counters", Some(self.counters.id)),
                ("step_params", self.step_params.as_ref().map(|bound| bound.id)),
                ("limits", Some(self.limits.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&CHOOSE_TIME_STEP, &CHOOSE_TIME_STEP_WITH_ADAPTIVE];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "step_state",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo {
        name: "time_step",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "counters",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_params", slot: 3, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "limits", slot: 4, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "step_state",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo {
        name: "time_step",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "counters",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "limits", slot: 3, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_sph_choose_time_step.deflate"));

static CHOOSE_TIME_STEP: Module = Module {
    name: "ChooseTimeStep",
    entry: "ChooseTimeStep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5688 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/choose_time_step.compute",
    hash: "38f0ce0d2e0a4e7498cda591c40cfd330c27cdd1c1b1b90d9308425182ad719a",
};

static CHOOSE_TIME_STEP_WITH_ADAPTIVE: Module = Module {
    name: "ChooseTimeStep+ADAPTIVE",
    entry: "ChooseTimeStep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5688, bytes: 5584 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/choose_time_step.compute",
    hash: "78d6b5963ec256cfaa9d6ac204befeeee9eccc18446325c41c9792f817c0f8cf",
};
