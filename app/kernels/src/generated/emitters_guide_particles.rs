// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from emitters/guide_particles.compute.
//! Kernels of `emitters/guide_particles.compute`.

use super::{EmissionParams, Emitter, EmitterFlow, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Particles in a nozzle and just before it keep to its flow: one after the other pushed a little out of its lattice's place, and
/// fluid's pressure makes a velocity of what the next layer finds in its way, more with each layer. Whoever stands there is
/// carried along, as by the walls of a pipe.
#[derive(Debug)]
pub struct GuideParticles<'a> {
    /// `StructuredBuffer<Emitter> emitters`.
    pub emitters: Buf<'a, Emitter>,
    /// `StructuredBuffer<EmitterFlow> emitter_flows`.
    pub emitter_flows: Buf<'a, EmitterFlow>,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<EmissionParams> emission_params`.
    pub emission_params: Uniform<'a, EmissionParams>,
}

impl Kernel for GuideParticles<'_> {
    const STAGE: &'static str = "guide_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &GUIDE_PARTICLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("emitters", Some(self.emitters.id)),
                ("emitter_flows", Some(self.emitter_flows.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("emission_params", Some(self.emission_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&GUIDE_PARTICLES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "emitters", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "emitter_flows",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 },
    },
    BindingInfo { name: "positions", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "velocities",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "emission_params", slot: 5, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/emitters_guide_particles.deflate"));

static GUIDE_PARTICLES: Module = Module {
    name: "GuideParticles",
    entry: "GuideParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7536 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/guide_particles.compute",
    hash: "b9302bc9b454685eb35a4ae263b80d8a734863d472af289aa098c044e2dac4df",
};
