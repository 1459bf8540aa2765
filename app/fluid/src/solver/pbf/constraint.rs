//! One Jacobi iteration: the density constraint's multipliers, then the corrections they ask for.

use brooklet_gpu::Recording;
use brooklet_kernels::{
    Buffer, ConstrainDensity, ConstrainDensityVariant, CorrectPositions, CorrectPositionsVariant, Iterate,
};

use super::{Pbf, Shared};
use crate::grid::Neighbours;

/// λ of each particle into `pbf.constrained`. (Shader: `solver/pbf/constrain_density.compute`.)
pub(super) fn constrain_density(
    recording: &mut Recording,
    pbf: &mut Pbf,
    shared: &Shared,
    neighbours: &Neighbours,
    iterates: &Buffer<Iterate>,
) {
    recording.dispatch(
        &ConstrainDensity {
            variant: ConstrainDensityVariant { walls: shared.walls_keyword() },
            iterates: iterates.read(),
            neighbours: neighbours.indices.read(),
            neighbour_counts: neighbours.counts.read(),
            constrained: pbf.constrained.write(),
            wall_weights: shared.wall_weights.as_ref().map(Buffer::read),
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
            pbf: pbf.params.uniform(),
        },
        iterates.len,
    );
}

/// Moves the iterates by what the multipliers ask for. (Shader: `solver/pbf/correct_positions.compute`.)
pub(super) fn correct_positions(
    recording: &mut Recording,
    pbf: &Pbf,
    shared: &mut Shared,
    neighbours: &Neighbours,
    iterates: &mut Buffer<Iterate>,
) {
    let count = iterates.len;
    recording.dispatch(
        &CorrectPositions {
            variant: CorrectPositionsVariant { walls: shared.walls_keyword(), s_corr: pbf.s_corr },
            constrained: pbf.constrained.read(),
            neighbours: neighbours.indices.read(),
            neighbour_counts: neighbours.counts.read(),
            iterates: iterates.write(),
            counters: shared.counters.write(),
            wall_weights: shared.wall_weights.as_ref().map(Buffer::read),
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
            pbf: pbf.params.uniform(),
        },
        count,
    );
}
