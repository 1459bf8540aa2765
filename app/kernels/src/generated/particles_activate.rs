// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/activate.compute.
//! Kernels of `particles/activate.compute`.

use super::{ActivateParams, Counters, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
};

/// Puts particles into inactive slots, which a sort leaves behind all others: ActivateParticles fills the slots,
/// ClaimSlots then counts them. They take part from the next substep on.
#[derive(Debug)]
pub struct ActivateParticles<'a> {
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<ActivateParams> activate`.
    pub activate: Uniform<'a, ActivateParams>,
}

impl Kernel for ActivateParticles<'_> {
    const STAGE: &'static str = "activate_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &ACTIVATE_PARTICLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("activate", Some(self.activate.id)),
            ],
        )
    }
}

/// Puts particles into inactive slots, which a sort leaves behind all others: ActivateParticles fills the slots,
/// ClaimSlots then counts them. They take part from the next substep on.
#[derive(Debug)]
pub struct ClaimSlots<'a> {
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `RWStructuredBuffer<StepState> claimed_state`.
    pub claimed_state: BufMut<'a, StepState>,
    /// `ConstantBuffer<ActivateParams> activate`.
    pub activate: Uniform<'a, ActivateParams>,
}

impl Kernel for ClaimSlots<'_> {
    const STAGE: &'static str = "claim_slots";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &CLAIM_SLOTS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("counters", Some(self.counters.id)),
                ("claimed_state", Some(self.claimed_state.id)),
                ("activate", Some(self.activate.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&ACTIVATE_PARTICLES, &CLAIM_SLOTS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "activate", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "counters",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo {
        name: "claimed_state",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "activate", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_activate.deflate"));

static ACTIVATE_PARTICLES: Module = Module {
    name: "ActivateParticles",
    entry: "ActivateParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3540 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/activate.compute",
    hash: "0c56b985fbc67f5399752ac56be2e42989b9ce22f9ad92d47c1b82a05a995ae9",
};

static CLAIM_SLOTS: Module = Module {
    name: "ClaimSlots",
    entry: "ClaimSlots",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 3540, bytes: 3064 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/activate.compute",
    hash: "44b3932d4076c94d22f53a26dbb19c6cd495cdf14bdfa3e73a4260ca60af636c",
};
