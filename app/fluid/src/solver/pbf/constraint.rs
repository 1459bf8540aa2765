//! One Jacobi iteration: the density constraint's multipliers, then the corrections they ask for.

use brooklet_gpu::Recording;
use brooklet_kernels::{ConstrainDensity, ConstrainDensityVariant, CorrectPositions, CorrectPositionsVariant};

use super::{Multipliers, Pbf, Shared};
use crate::grid::{Neighbours, Sorted};

/// λ of each particle into `pbf.constrained`. (Shader: `solver/pbf/constrain_density.compute`.)
pub(super) fn constrain_density(
    recording: &mut Recording,
    pbf: &mut Pbf,
    shared: &Shared,
    neighbours: &Neighbours,
    sorted: &Sorted,
) {
    let (constrained, packed_constrained) = match &mut pbf.constrained {
        Multipliers::Full(constrained) => (Some(constrained.write()), None),
        Multipliers::Packed(constrained) => (None, Some(constrained.write())),
    };
    recording.dispatch(
        &ConstrainDensity {
            variant: ConstrainDensityVariant {
                walls: shared.walls,
                precision: shared.precision,
                packed: sorted.packed,
            },
            places: sorted.places.read(),
            sorted_positions: shared.walls.then(|| sorted.positions.read()),
            neighbours: neighbours.gaps.read(),
            list_heads: neighbours.heads.read(),
            constrained,
            packed_constrained,
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
            pbf: pbf.params.uniform(),
        },
        sorted.positions.len,
    );
}

/// Moves the places by what the multipliers ask for. (Shader: `solver/pbf/correct_positions.compute`.)
pub(super) fn correct_positions(
    recording: &mut Recording,
    pbf: &Pbf,
    shared: &mut Shared,
    neighbours: &Neighbours,
    sorted: &mut Sorted,
) {
    let (constrained, packed_constrained) = match &pbf.constrained {
        Multipliers::Full(constrained) => (Some(constrained.read()), None),
        Multipliers::Packed(constrained) => (None, Some(constrained.read())),
    };
    recording.dispatch(
        &CorrectPositions {
            variant: CorrectPositionsVariant {
                walls: shared.walls,
                s_corr: pbf.s_corr,
                precision: shared.precision,
                packed: sorted.packed,
            },
            constrained,
            packed_constrained,
            sorted_positions: sorted.positions.read(),
            neighbours: neighbours.gaps.read(),
            list_heads: neighbours.heads.read(),
            places: sorted.places.write(),
            counters: shared.counters.write(),
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
            pbf: pbf.params.uniform(),
        },
        sorted.positions.len,
    );
}
