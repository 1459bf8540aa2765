// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from emitters/drain_particles.compute.
//! Kernels of `emitters/drain_particles.compute`.

use super::{Counters, Drain, DrainParams, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Empties the slots of particles in drains without a limit, and of those whose lifetime is over: an age below 0 is what is left
/// of one.
#[derive(Debug)]
pub struct DrainParticles<'a> {
    /// `StructuredBuffer<Drain> drains`.
    pub drains: Buf<'a, Drain>,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<DrainParams> drain_params`.
    pub drain_params: Uniform<'a, DrainParams>,
}

impl Kernel for DrainParticles<'_> {
    const STAGE: &'static str = "drain_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &DRAIN_PARTICLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("drains", Some(self.drains.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("drain_params", Some(self.drain_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAIN_PARTICLES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "drains", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo {
        name: "positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "counters",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "drain_params", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/emitters_drain_particles.deflate"));

static DRAIN_PARTICLES: Module = Module {
    name: "DrainParticles",
    entry: "DrainParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 6128 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 4,
    tier: Tier::Floor,
    source: "emitters/drain_particles.compute",
    hash: "2deca8c64aa5c86080d661fdce76f7a1e0d3add91d60fdb78464e062430f025b",
};
