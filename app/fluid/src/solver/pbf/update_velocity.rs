//! Positions and velocities after the corrections. (Shader: `solver/pbf/update_velocity.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{Buffer, Position, UpdateVelocity, UpdateVelocityVariant, Velocity};

use crate::grid::NeighbourSearch;
use crate::step_context::StepContext;

/// What becomes of velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Velocities {
    /// They take what the corrections moved, over dt.
    TakeCorrections,
    /// They stay.
    Keep,
}

/// From what the sort predicted and where the iterations moved it.
pub(super) fn update_velocity(
    recording: &mut Recording,
    context: &mut StepContext,
    search: &NeighbourSearch,
    positions: &mut Buffer<Position>,
    velocities: &mut Buffer<Velocity>,
    what: Velocities,
) {
    let sorted = &search.sorted;
    let keep_velocity = what == Velocities::Keep;
    context.slots.dispatch(
        recording,
        &UpdateVelocity {
            variant: UpdateVelocityVariant { precision: sorted.precision, periodic: context.periodic, keep_velocity },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: sorted.positions.read(),
            sorted_velocities: sorted.velocities.read(),
            positions: positions.write(),
            velocities: velocities.write(),
            counters: (!keep_velocity).then(|| context.counters.write()),
            step_state: context.slots.state.uniform(),
            step_params: (!keep_velocity || context.periodic).then(|| context.step.uniform()),
            kernel: search.smoothing_kernel.uniform(),
        },
    );
}
