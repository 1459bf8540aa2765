// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/multiply_add.compute.
//! Kernels of `bench/multiply_add.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// How many multiplications with an addition the device does in f32: eight chains a thread, each as long as a unit's
/// latency needs. `brooklet bench` compares the passes of a step with it; nothing else runs it.
#[derive(Debug)]
pub struct MultiplyAdd<'a> {
    /// `RWStructuredBuffer<float> chain_sums`.
    pub chain_sums: BufMut<'a, f32>,
}

impl Kernel for MultiplyAdd<'_> {
    const STAGE: &'static str = "multiply_add";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MULTIPLY_ADD
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(self.module(), &[("chain_sums", Some(self.chain_sums.id))])
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MULTIPLY_ADD];

static BINDINGS_0: &[BindingInfo] = &[BindingInfo {
    name: "chain_sums",
    slot: 0,
    kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
}];

static MULTIPLY_ADD: Module = Module {
    name: "MultiplyAdd",
    entry: "MultiplyAdd",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/multiply_add.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/multiply_add.compute",
    hash: "8b4e5dd6f81e226ac694e191984889319b1b504e0f7885a65aefe161f1b068b2",
};
