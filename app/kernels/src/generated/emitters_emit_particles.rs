// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from emitters/emit_particles.compute.
//! Kernels of `emitters/emit_particles.compute`.

use super::{Emission, EmissionParams, Emitter, EmitterFlow, EmitterPoint, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Puts the particles of a substep's layers into the slots that were claimed for them: by emitter, layer and lattice point. Each
/// is off its point by a little, drawn from these three, and has the flow's velocity and its nozzle's.
#[derive(Debug)]
pub struct EmitParticles<'a> {
    /// `StructuredBuffer<Emitter> emitters`.
    pub emitters: Buf<'a, Emitter>,
    /// `StructuredBuffer<EmitterPoint> emitter_points`.
    pub emitter_points: Buf<'a, EmitterPoint>,
    /// `StructuredBuffer<EmitterFlow> emitter_flows`.
    pub emitter_flows: Buf<'a, EmitterFlow>,
    /// `StructuredBuffer<Emission> emission`.
    pub emission: Buf<'a, Emission>,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<EmissionParams> emission_params`.
    pub emission_params: Uniform<'a, EmissionParams>,
}

impl Kernel for EmitParticles<'_> {
    const STAGE: &'static str = "emit_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &EMIT_PARTICLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("emitters", Some(self.emitters.id)),
                ("emitter_points", Some(self.emitter_points.id)),
                ("emitter_flows", Some(self.emitter_flows.id)),
                ("emission", Some(self.emission.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("emission_params", Some(self.emission_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&EMIT_PARTICLES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "emitters", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "emitter_points",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "emitter_flows",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 },
    },
    BindingInfo { name: "emission", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo {
        name: "positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "emission_params", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/emitters_emit_particles.deflate"));

static EMIT_PARTICLES: Module = Module {
    name: "EmitParticles",
    entry: "EmitParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 9208 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/emit_particles.compute",
    hash: "e5bf3312244e62e32e7e93f3110b9571e49c04f069c88579b5a3a9051c52e127",
};
