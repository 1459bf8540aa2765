//! Positions and velocities after the corrections. (Shader: `solver/pbf/update_velocity.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{UpdateVelocity, UpdateVelocityVariant, VelocityKeyword};

use crate::grid::{NeighbourSearch, Sorted};
use crate::particles::buffers::Particles;
use crate::step_context::StepContext;

/// What becomes of velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Velocities {
    /// They take what the corrections moved, over dt.
    TakeCorrections,
    /// The same where the sort left them: a force takes them from there.
    TakeInPlace,
    /// They stay.
    Keep,
}

/// From what the sort predicted and where the iterations moved it.
pub(super) fn update_velocity(
    recording: &mut Recording,
    context: &mut StepContext,
    search: &mut NeighbourSearch,
    particles: &mut Particles,
    what: Velocities,
) {
    let Sorted { positions: sorted_positions, velocities: sorted_velocities, quantized_positions, precision } =
        &mut search.sorted;
    let velocity = match what {
        Velocities::TakeCorrections => VelocityKeyword::Off,
        Velocities::TakeInPlace => VelocityKeyword::InPlaceVelocity,
        Velocities::Keep => VelocityKeyword::KeepVelocity,
    };
    let (sorted_velocities, velocities) = match what {
        Velocities::TakeInPlace => (None, sorted_velocities.write()),
        Velocities::TakeCorrections | Velocities::Keep => {
            (Some(sorted_velocities.read()), particles.velocities.write())
        }
    };
    let takes = what != Velocities::Keep;
    context.slots.dispatch(
        recording,
        &UpdateVelocity {
            variant: UpdateVelocityVariant { precision: *precision, periodic: context.periodic, velocity },
            quantized_positions: quantized_positions.read(),
            sorted_positions: sorted_positions.read(),
            sorted_velocities,
            positions: particles.positions.write(),
            velocities,
            counters: takes.then(|| context.counters.write()),
            step_state: context.slots.state.uniform(),
            step_params: (takes || context.periodic).then(|| context.step.uniform()),
            kernel: search.smoothing_kernel.uniform(),
        },
    );
}
