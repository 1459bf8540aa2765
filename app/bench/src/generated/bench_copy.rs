// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/copy.compute.
//! Kernels of `bench/copy.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// What the device can move: a copy from one large buffer to another, as STREAM's (McCalpin 1995).
/// `brooklet bench` compares the passes of a step with it; nothing else runs it.
#[derive(Debug)]
pub struct CopyElements<'a> {
    /// `StructuredBuffer<float4> from_elements`.
    pub from_elements: Buf<'a, [f32; 4]>,
    /// `RWStructuredBuffer<float4> to_elements`.
    pub to_elements: BufMut<'a, [f32; 4]>,
}

impl Kernel for CopyElements<'_> {
    const STAGE: &'static str = "copy_elements";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COPY_ELEMENTS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[("from_elements", Some(self.from_elements.id)), ("to_elements", Some(self.to_elements.id))],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COPY_ELEMENTS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "from_elements",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "to_elements",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
];

static COPY_ELEMENTS: Module = Module {
    name: "CopyElements",
    entry: "CopyElements",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/copy_elements.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/copy.compute",
    hash: "73e167ce037e9b8c498c2e85eb1244425480c918fac52e5b95948bacff18416d",
};
