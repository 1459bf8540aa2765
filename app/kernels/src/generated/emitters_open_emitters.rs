// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from emitters/open_emitters.compute.
//! Kernels of `emitters/open_emitters.compute`.

use super::{Counters, Emission, EmissionParams, Emitter, EmitterFlow, EmitterState, Keyframe, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// What each emitter does in a substep that was begun: where its nozzle is, which layers are due, and which of their
/// particles find a slot, in the emitters' order. The substep then visits those slots as well. One group: emitters are few.
#[derive(Debug)]
pub struct OpenEmitters<'a> {
    /// `StructuredBuffer<Emitter> emitters`.
    pub emitters: Buf<'a, Emitter>,
    /// `StructuredBuffer<Keyframe> keyframes`.
    pub keyframes: Buf<'a, Keyframe>,
    /// `RWStructuredBuffer<EmitterState> emitter_states`.
    pub emitter_states: BufMut<'a, EmitterState>,
    /// `RWStructuredBuffer<EmitterFlow> emitter_flows`.
    pub emitter_flows: BufMut<'a, EmitterFlow>,
    /// `RWStructuredBuffer<Emission> emission`.
    pub emission: BufMut<'a, Emission>,
    /// `RWStructuredBuffer<StepState> step_state`.
    pub step_state: BufMut<'a, StepState>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<EmissionParams> emission_params`.
    pub emission_params: Uniform<'a, EmissionParams>,
}

impl Kernel for OpenEmitters<'_> {
    const STAGE: &'static str = "open_emitters";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &OPEN_EMITTERS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("emitters", Some(self.emitters.id)),
                ("keyframes", Some(self.keyframes.id)),
                ("emitter_states", Some(self.emitter_states.id)),
                ("emitter_flows", Some(self.emitter_flows.id)),
                ("emission", Some(self.emission.id)),
                ("step_state", Some(self.step_state.id)),
                ("counters", Some(self.counters.id)),
                ("emission_params", Some(self.emission_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&OPEN_EMITTERS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "emitters", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "keyframes", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo {
        name: "emitter_states",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "emitter_flows",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 80 },
    },
    BindingInfo {
        name: "emission",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "step_state",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo {
        name: "counters",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "emission_params", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/emitters_open_emitters.deflate"));

static OPEN_EMITTERS: Module = Module {
    name: "OpenEmitters",
    entry: "OpenEmitters",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 13680 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "emitters/open_emitters.compute",
    hash: "7fdb0cb6a933a85d253affa167bf8fa5435726b78d399ff6f0cf62bca06fc621",
};
