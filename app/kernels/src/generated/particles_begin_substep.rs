// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/begin_substep.compute.
//! Kernels of `particles/begin_substep.compute`.

use super::{StepParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
};

/// Opens a substep: the time it takes, and the slots it visits.
#[derive(Debug)]
pub struct BeginSubstep<'a> {
    /// `RWStructuredBuffer<StepState> step_state`.
    pub step_state: BufMut<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
}

impl Kernel for BeginSubstep<'_> {
    const STAGE: &'static str = "begin_substep";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &BEGIN_SUBSTEP
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(self.module(), &[("step_state", Some(self.step_state.id)), ("step_params", Some(self.step_params.id))])
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&BEGIN_SUBSTEP];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "step_state",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "step_params", slot: 1, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_begin_substep.deflate"));

static BEGIN_SUBSTEP: Module = Module {
    name: "BeginSubstep",
    entry: "BeginSubstep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2444 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/begin_substep.compute",
    hash: "36b0ce6034e1bf184dbf49924556029dad31aa520954b513acc7a71c8ebe0b19",
};
