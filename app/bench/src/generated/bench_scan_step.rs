// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/scan_step.compute.
//! Kernels of `bench/scan_step.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// A prefix sum in global memory, one dispatch for each doubling of the reach (Hillis & Steele 1986).
/// What `brooklet bench sorting` holds against it is grid/scan.compute, in groupshared memory.
#[derive(Debug)]
pub struct ScanStep<'a> {
    /// `StructuredBuffer<uint> values`.
    pub values: Buf<'a, u32>,
    /// one element: 0 shifts by one, which makes the sum exclusive
    ///
    /// `StructuredBuffer<uint> reach`.
    pub reach: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> scanned`.
    pub scanned: BufMut<'a, u32>,
}

impl Kernel for ScanStep<'_> {
    const STAGE: &'static str = "scan_step";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SCAN_STEP
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[("values", Some(self.values.id)), ("reach", Some(self.reach.id)), ("scanned", Some(self.scanned.id))],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SCAN_STEP];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "values", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "reach", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "scanned", slot: 2, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
];

static SCAN_STEP: Module = Module {
    name: "ScanStep",
    entry: "ScanStep",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/scan_step.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/scan_step.compute",
    hash: "fb517dfaa386e014ba18177020cf10c5b40223533778b3e5dffa091343b1510a",
};
