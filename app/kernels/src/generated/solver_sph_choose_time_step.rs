// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/choose_time_step.compute.
//! Kernels of `solver/sph/choose_time_step.compute`.

use super::{Counters, SearchGroups, SphLimits, SphTimeStep, StepParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
};

/// Which variant of [`ChooseTimeStep`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ChooseTimeStepVariant {
    /// Keyword `ADAPTIVE`.
    pub adaptive: bool,
    /// Keyword `KEEPS_LISTS`.
    pub keeps_lists: bool,
}

/// Opens a substep: holds its dt against what the fluid allows (CFL, viscosity, force, surface tension), and counts it where
/// it is more. With ADAPTIVE it takes as few substeps to the step's end as are allowed; those left over visit nothing. With
/// KEEPS\_LISTS a substep sorts and lists particles only where they may have moved too far since the last one did, and in a
/// step's first: kernels have no slope where a pair meets their support, so pairs that are listed a little late weigh nothing.
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
    /// `RWStructuredBuffer<SearchGroups> search_groups`.
    pub search_groups: Option<BufMut<'a, SearchGroups>>,
}

impl Kernel for ChooseTimeStep<'_> {
    const STAGE: &'static str = "choose_time_step";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.adaptive, self.variant.keeps_lists) {
            (false, false) => &CHOOSE_TIME_STEP,
            (false, true) => &CHOOSE_TIME_STEP_WITH_KEEPS_LISTS,
            (true, false) => &CHOOSE_TIME_STEP_WITH_ADAPTIVE,
            (true, true) => &CHOOSE_TIME_STEP_WITH_ADAPTIVE_WITH_KEEPS_LISTS,
        }
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
                ("search_groups", self.search_groups.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CHOOSE_TIME_STEP,
    &CHOOSE_TIME_STEP_WITH_KEEPS_LISTS,
    &CHOOSE_TIME_STEP_WITH_ADAPTIVE,
    &CHOOSE_TIME_STEP_WITH_ADAPTIVE_WITH_KEEPS_LISTS,
];

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
    BindingInfo { name: "limits", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
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
    BindingInfo {
        name: "search_groups",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "limits", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
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
    BindingInfo { name: "limits", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_3: &[BindingInfo] = &[
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
    BindingInfo {
        name: "search_groups",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo { name: "limits", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_sph_choose_time_step.deflate"));

static CHOOSE_TIME_STEP: Module = Module {
    name: "ChooseTimeStep",
    entry: "ChooseTimeStep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5900 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/choose_time_step.compute",
    hash: "8d84bbe3ba81f70624fa541497cf2c8ff10c3c1c6b8a9a66e0d4802e6daec698",
};

static CHOOSE_TIME_STEP_WITH_KEEPS_LISTS: Module = Module {
    name: "ChooseTimeStep+KEEPS_LISTS",
    entry: "ChooseTimeStep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5900, bytes: 7504 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/choose_time_step.compute",
    hash: "b32fe262a00b7d6fb091effcb4a3e32ac2e535024bf4524487ea30b72e9cdbd7",
};

static CHOOSE_TIME_STEP_WITH_ADAPTIVE: Module = Module {
    name: "ChooseTimeStep+ADAPTIVE",
    entry: "ChooseTimeStep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 13404, bytes: 5680 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/choose_time_step.compute",
    hash: "1355f567d6d010fa0b11173abc4db6c555ca936dc4ad58e6a022c23cf5af6cd6",
};

static CHOOSE_TIME_STEP_WITH_ADAPTIVE_WITH_KEEPS_LISTS: Module = Module {
    name: "ChooseTimeStep+ADAPTIVE+KEEPS_LISTS",
    entry: "ChooseTimeStep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19084, bytes: 7284 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/choose_time_step.compute",
    hash: "92bfa45bde57ab9d86ae3d9b7f8ea0822feb5967e3e98031daaac83a079063d2",
};
