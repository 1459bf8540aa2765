//! Forces, and what velocities take of them. (Shader: `solver/sph/accelerate.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{Accelerate, AccelerateVariant};

use super::{Gathered, Sph};
use crate::particles::buffers::Particles;
use crate::step_context::StepContext;

pub(super) fn accelerate(recording: &mut Recording, sph: &mut Sph, context: &StepContext, particles: &mut Particles) {
    let (velocity_pressures, velocity_pressure_normals) = match &sph.gathered {
        Gathered::Flow(flow) => (Some(flow.read()), None),
        Gathered::FlowAndSurface { both, .. } => (None, Some(both.read())),
    };
    let (sorted, neighbours) = (&sph.search.sorted, &sph.search.neighbours);
    context.slots.dispatch(
        recording,
        &Accelerate {
            variant: AccelerateVariant {
                walls: context.walls,
                chosen_kernels: sph.chosen_kernels,
                surface_tension: velocity_pressure_normals.is_some(),
                precision: sorted.precision,
            },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: sorted.positions.read(),
            velocity_pressures,
            velocity_pressure_normals,
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            velocities: particles.velocities.write(),
            accelerations: sph.accelerations.write(),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            pressure_walls: sph.pressure_walls.uniform(),
            kernels: sph.kernels.uniform(),
            sph: sph.params.uniform(),
        },
    );
}
