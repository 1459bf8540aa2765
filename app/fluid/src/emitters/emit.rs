//! Emitters: which layers are due, and their particles. (Shaders: `emitters/open_emitters.compute`,
//! `emitters/emit_particles.compute`.)

use std::mem::offset_of;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, Counters, Emission, EmissionParams, EmitParticles, Emitter, EmitterFlow, EmitterPoint, EmitterState,
    GuideParticles, Keyframe, OpenEmitters,
};

use crate::particles::buffers::Particles;
use crate::scene::{Scene, emitters};
use crate::slots::Slots;

/// The emitters of a scene.
pub struct Emitters {
    emitters: Buffer<Emitter>,
    points: Buffer<EmitterPoint>,
    keyframes: Buffer<Keyframe>,
    states: Buffer<EmitterState>,
    flows: Buffer<EmitterFlow>,
    emission: Buffer<Emission>,
    params: Buffer<EmissionParams>,
    /// Whether particles that meet are to keep to the flow of a nozzle.
    guides: bool,
    most_a_substep: u32,
}

/// What the shaders are told of all of them, where there are `capacity` slots.
pub fn emission_params(scene: &Scene, capacity: u32) -> EmissionParams {
    EmissionParams {
        emitters: scene.emitters.len() as u32,
        capacity,
        spacing_m: scene.fitted_spacing_m() as f32,
        along_z: if scene.domain.is_flat() { 0.0 } else { 1.0 },
        guide_m: scene.support_m() as f32,
        ..EmissionParams::default()
    }
}

impl Emitters {
    /// None of a scene that has none.
    pub(super) fn declare(resources: &mut Resources, scene: &Scene) -> Option<Self> {
        let tables = emitters(scene);
        let count = tables.emitters.len() as u32;
        (count > 0).then(|| Self {
            emitters: resources.persistent("emitters", count),
            points: resources.persistent("emitter_points", tables.points.len().max(1) as u32),
            keyframes: resources.persistent("emitter_keyframes", tables.keyframes.len() as u32),
            states: resources.persistent("emitter_states", count),
            flows: resources.buffer("emitter_flows", count),
            emission: resources.persistent("emission", 1),
            params: resources.persistent("emission_params", 1),
            guides: scene.solver.method.interacts() && scene.emitters.iter().any(|emitter| !emitter.fills()),
            most_a_substep: tables.most_a_substep(),
        })
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene, capacity: u32) {
        let tables = emitters(scene);
        init.upload(&mut self.emitters, &tables.emitters);
        init.upload(&mut self.points, &tables.points);
        init.upload(&mut self.keyframes, &tables.keyframes);
        init.upload(&mut self.params, &[emission_params(scene, capacity)]);
        init.clear(&mut self.states);
        init.clear(&mut self.emission);
    }

    pub(super) fn record(
        &mut self,
        recording: &mut Recording,
        slots: &mut Slots,
        counters: &mut Buffer<Counters>,
        particles: &mut Particles,
    ) {
        recording.dispatch_groups(
            &OpenEmitters {
                emitters: self.emitters.read(),
                keyframes: self.keyframes.read(),
                emitter_states: self.states.write(),
                emitter_flows: self.flows.write(),
                emission: self.emission.write(),
                step_state: slots.state.write(),
                counters: counters.write(),
                emission_params: self.params.uniform(),
            },
            [1; 3],
        );
        if self.guides {
            slots.dispatch(
                recording,
                &GuideParticles {
                    emitters: self.emitters.read(),
                    emitter_flows: self.flows.read(),
                    positions: particles.positions.read(),
                    velocities: particles.velocities.write(),
                    step_state: slots.state.uniform(),
                    emission_params: self.params.uniform(),
                },
            );
        }
        recording.dispatch_indirect(
            &EmitParticles {
                emitters: self.emitters.read(),
                emitter_points: self.points.read(),
                emitter_flows: self.flows.read(),
                emission: self.emission.read(),
                positions: particles.positions.write(),
                velocities: particles.velocities.write(),
                step_state: slots.state.uniform(),
                emission_params: self.params.uniform(),
            },
            &self.emission,
            offset_of!(Emission, groups) as u32,
            self.most_a_substep.min(slots.capacity),
        );
    }

    /// What lasts of them from substep to substep.
    pub(super) fn states(&self) -> &Buffer<EmitterState> {
        &self.states
    }
}
