//! One Jacobi iteration: the density constraint's multipliers, then the corrections they ask for.

use brooklet_gpu::Recording;
use brooklet_kernels::{ConstrainDensity, ConstrainDensityVariant, CorrectPositions, CorrectPositionsVariant};

use super::{Lambdas, Pbf, Shared};
use crate::grid::{Neighbours, Sorted};

/// λ of each particle into `pbf.position_lambdas`. (Shader: `solver/pbf/constrain_density.compute`.)
pub(super) fn constrain_density(
    recording: &mut Recording,
    pbf: &mut Pbf,
    shared: &Shared,
    neighbours: &Neighbours,
    sorted: &Sorted,
) {
    let (position_lambdas, packed_position_lambdas) = match &mut pbf.position_lambdas {
        Lambdas::Full(position_lambdas) => (Some(position_lambdas.write()), None),
        Lambdas::Packed(position_lambdas) => (None, Some(position_lambdas.write())),
    };
    recording.dispatch(
        &ConstrainDensity {
            variant: ConstrainDensityVariant {
                walls: shared.walls,
                precision: shared.precision,
                packed: sorted.packed,
            },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: shared.walls.then(|| sorted.positions.read()),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            position_lambdas,
            packed_position_lambdas,
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
            pbf: pbf.params.uniform(),
        },
        sorted.positions.len,
    );
}

/// Moves the quantized_positions by what the multipliers ask for. (Shader: `solver/pbf/correct_positions.compute`.)
pub(super) fn correct_positions(
    recording: &mut Recording,
    pbf: &Pbf,
    shared: &mut Shared,
    neighbours: &Neighbours,
    sorted: &mut Sorted,
) {
    let (position_lambdas, packed_position_lambdas) = match &pbf.position_lambdas {
        Lambdas::Full(position_lambdas) => (Some(position_lambdas.read()), None),
        Lambdas::Packed(position_lambdas) => (None, Some(position_lambdas.read())),
    };
    recording.dispatch(
        &CorrectPositions {
            variant: CorrectPositionsVariant {
                walls: shared.walls,
                s_corr: pbf.s_corr,
                precision: shared.precision,
                packed: sorted.packed,
            },
            position_lambdas,
            packed_position_lambdas,
            sorted_positions: sorted.positions.read(),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            quantized_positions: sorted.quantized_positions.write(),
            counters: shared.counters.write(),
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
            pbf: pbf.params.uniform(),
        },
        sorted.positions.len,
    );
}
