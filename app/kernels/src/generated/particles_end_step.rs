// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/end_step.compute.
//! Kernels of `particles/end_step.compute`.

use super::StepState;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// Ends a step whose substeps the GPU chose: what reads the particles now visits all of them, though the last substeps that
/// were left over visited none.
#[derive(Debug)]
pub struct EndStep<'a> {
    /// `RWStructuredBuffer<StepState> step_state`.
    pub step_state: BufMut<'a, StepState>,
}

impl Kernel for EndStep<'_> {
    const STAGE: &'static str = "end_step";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &END_STEP
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(self.module(), &[("step_state", Some(self.step_state.id))])
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&END_STEP];

static BINDINGS_0: &[BindingInfo] = &[BindingInfo {
    name: "step_state",
    slot: 0,
    kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
}];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_end_step.deflate"));

static END_STEP: Module = Module {
    name: "EndStep",
    entry: "EndStep",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 1544 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/end_step.compute",
    hash: "7e867a0d6c9375d47c9635fc5b4c430880524283a11898e26f6c4666b5142e85",
};
