//! Where particles go with their velocities. (Shader: `particles/advect.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{Advect, AdvectVariant, Buffer, KickParams};

use crate::particles::buffers::Particles;
use crate::step_context::StepContext;

/// Moves particles; with the last substep's accelerations, by slot, and how they are split around the move.
pub fn advect(
    recording: &mut Recording,
    context: &mut StepContext,
    particles: &mut Particles,
    accelerated: Option<(&Buffer<[f32; 4]>, &Buffer<KickParams>)>,
) {
    let (accelerations, kicks) = accelerated.unzip();
    context.slots.dispatch(
        recording,
        &Advect {
            variant: AdvectVariant {
                accelerated: accelerations.is_some(),
                walls: context.walls,
                periodic: context.periodic,
            },
            positions: particles.positions.write(),
            velocities: particles.velocities.write(),
            accelerations: accelerations.map(|accelerations| accelerations.read()),
            counters: context.counters.write(),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kicks: kicks.map(|kicks| kicks.uniform()),
        },
    );
}
