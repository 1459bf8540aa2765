//! Positions and velocities after the corrections. (Shader: `solver/pbf/update_velocity.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{Buffer, Position, UpdateVelocity, UpdateVelocityVariant, Velocity};

use crate::grid::NeighbourSearch;
use crate::step_context::StepContext;

/// From what the sort predicted and where the iterations moved it.
pub(super) fn update_velocity(
    recording: &mut Recording,
    context: &mut StepContext,
    search: &NeighbourSearch,
    positions: &mut Buffer<Position>,
    velocities: &mut Buffer<Velocity>,
) {
    let sorted = &search.sorted;
    context.slots.dispatch(
        recording,
        &UpdateVelocity {
            variant: UpdateVelocityVariant { precision: sorted.precision, periodic: context.periodic },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: sorted.positions.read(),
            sorted_velocities: sorted.velocities.read(),
            positions: positions.write(),
            velocities: velocities.write(),
            counters: context.counters.write(),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kernel: search.smoothing_kernel.uniform(),
        },
    );
}
