//! Where each particle would go without its neighbours. (Shader: `particles/predict.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{Predict, PredictVariant};

use crate::particles::buffers::Particles;
use crate::step_context::StepContext;

/// Records v += g dt, x += v dt, and what the domain's faces make of it.
pub fn predict(recording: &mut Recording, context: &mut StepContext, particles: &mut Particles) {
    context.slots.dispatch(
        recording,
        &Predict {
            variant: PredictVariant { walls: context.walls, periodic: context.periodic },
            positions: particles.positions.write(),
            velocities: particles.velocities.write(),
            counters: context.counters.write(),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
        },
    );
}
