// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/measure_totals.compute.
//! Kernels of `measure/measure_totals.compute`.

use super::{Counters, Measure, MeasureSums, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The groups' sums to one, and the 99th percentiles from the histograms. One group: a few
/// thousand sums, a few hundred bytes for the host to read.
#[derive(Debug)]
pub struct MeasureTotals<'a> {
    /// `StructuredBuffer<MeasureSums> group_measures`.
    pub group_measures: Buf<'a, MeasureSums>,
    /// `StructuredBuffer<uint> histograms`.
    pub histograms: Buf<'a, u32>,
    /// `StructuredBuffer<Counters> counters`.
    pub counters: Buf<'a, Counters>,
    /// `RWStructuredBuffer<Measure> measure`.
    pub measure: BufMut<'a, Measure>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for MeasureTotals<'_> {
    const STAGE: &'static str = "measure_totals";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MEASURE_TOTALS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("group_measures", Some(self.group_measures.id)),
                ("histograms", Some(self.histograms.id)),
                ("counters", Some(self.counters.id)),
                ("measure", Some(self.measure.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MEASURE_TOTALS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "group_measures",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo { name: "histograms", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "counters", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 } },
    BindingInfo {
        name: "measure",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 144 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/measure_measure_totals.deflate"));

static MEASURE_TOTALS: Module = Module {
    name: "MeasureTotals",
    entry: "MeasureTotals",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 9148 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 4616,
    tier: Tier::Floor,
    source: "measure/measure_totals.compute",
    hash: "91d2bcd69cb79de316c957a0aac36fd1aa0b3a7e1bd92cfc30dc7a7b554a1e3d",
};
