//! Density and pressure. (Shader: `solver/sph/compute_density.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{ComputeDensity, ComputeDensityVariant};

use super::{Gathered, Sph};
use crate::particles::buffers::Particles;
use crate::step_context::StepContext;

/// Of the sorted particles, which from then on are the particles.
pub(super) fn compute_density(
    recording: &mut Recording,
    sph: &mut Sph,
    context: &StepContext,
    particles: &mut Particles,
) {
    let (velocity_pressures, velocity_pressure_normals, tension_walls) = match &mut sph.gathered {
        Gathered::Flow(flow) => (Some(flow.write()), None, None),
        Gathered::FlowAndSurface { both, walls } => (None, Some(both.write()), context.walls.then(|| walls.uniform())),
    };
    let (sorted, neighbours) = (&sph.search.sorted, &sph.search.neighbours);
    let surface_tension = velocity_pressure_normals.is_some();
    context.slots.dispatch(
        recording,
        &ComputeDensity {
            variant: ComputeDensityVariant {
                walls: context.walls,
                chosen_kernels: sph.chosen_kernels,
                surface_tension,
                precision: sorted.precision,
            },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: sorted.positions.read(),
            sorted_velocities: sorted.velocities.read(),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            positions: particles.positions.write(),
            velocities: particles.velocities.write(),
            velocity_pressures,
            velocity_pressure_normals,
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            density_walls: context.walls.then(|| sph.density_walls.uniform()),
            tension_walls,
            kernels: sph.kernels.uniform(),
            sph: sph.params.uniform(),
        },
    );
}
