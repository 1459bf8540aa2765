// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/gather_elements.compute.
//! Kernels of `bench/gather_elements.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// How many elements the device can gather: each thread reads those of eight runs of four, a row of cells apart, as a
/// particle reads its neighbours in a sorted fluid; there are as many behind the last thread's. `brooklet bench` compares the passes of a step with it; nothing else
/// runs it.
#[derive(Debug)]
pub struct GatherElements<'a> {
    /// `StructuredBuffer<uint2> from_elements`.
    pub from_elements: Buf<'a, [u32; 2]>,
    /// `RWStructuredBuffer<uint> gathered`.
    pub gathered: BufMut<'a, u32>,
}

impl Kernel for GatherElements<'_> {
    const STAGE: &'static str = "gather_elements";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &GATHER_ELEMENTS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(self.module(), &[("from_elements", Some(self.from_elements.id)), ("gathered", Some(self.gathered.id))])
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&GATHER_ELEMENTS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "from_elements",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "gathered",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
];

static GATHER_ELEMENTS: Module = Module {
    name: "GatherElements",
    entry: "GatherElements",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/gather_elements.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/gather_elements.compute",
    hash: "d513d2cd4ea0c3638f35b0c32b7647f3fe3854b4cf85ab41e3b58d2bf3161b5b",
};
