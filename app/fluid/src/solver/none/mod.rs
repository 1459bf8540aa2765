//! Particles that do not interact: they age, fall, are dragged and bounce. No grid, no lists, no densities.
//! (Shader: `solver/none/integrate_particles.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{BounceWalls, Buffer, IntegrateParticles, IntegrateParticlesVariant, NoneParams};

use crate::particles::buffers::Particles;
use crate::scene::Scene;
use crate::step_context::StepContext;

/// Their settings.
pub struct NonInteracting {
    pub(crate) params: Buffer<NoneParams>,
}

/// What the shader is given.
pub fn params(scene: &Scene) -> NoneParams {
    let settings = &scene.solver.none;
    NoneParams {
        lifetime_s: settings.lifetime_s as f32,
        lifetime_variation: settings.lifetime_variation as f32,
        drag_per_s: settings.drag_per_s as f32,
        restitution: settings.restitution as f32,
    }
}

impl NonInteracting {
    /// Declares their one buffer.
    pub fn declare(resources: &mut Resources) -> Self {
        Self { params: resources.persistent("none_params", 1) }
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.params, &[params(scene)]);
    }

    pub(super) fn record_substep(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        particles: &mut Particles,
    ) {
        context.slots.dispatch(
            recording,
            &IntegrateParticles {
                variant: IntegrateParticlesVariant {
                    walls: context.walls && context.solids.is_none(),
                    periodic: context.periodic,
                },
                positions: particles.positions.write(),
                velocities: particles.velocities.write(),
                counters: context.counters.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                none: self.params.uniform(),
            },
        );
        if let Some(solids) = &mut context.solids {
            solids.record_collide(recording, &mut particles.positions, &mut particles.velocities);
            self.bounce_walls(recording, context, particles);
        }
    }

    /// Where solids are met before walls. (Shader: `particles/bounce_walls.compute`.)
    fn bounce_walls(&self, recording: &mut Recording, context: &StepContext, particles: &mut Particles) {
        if !context.walls {
            return;
        }
        context.slots.dispatch(
            recording,
            &BounceWalls {
                positions: particles.positions.write(),
                velocities: particles.velocities.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                none: self.params.uniform(),
            },
        );
    }
}
