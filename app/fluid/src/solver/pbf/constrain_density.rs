//! λ of each particle. (Shader: `solver/pbf/constrain_density.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{ConstrainDensity, ConstrainDensityVariant};

use super::{Lambdas, Pbf};
use crate::step_context::StepContext;

/// From quantized positions to `pbf.lambdas`.
pub(super) fn constrain_density(recording: &mut Recording, pbf: &mut Pbf, context: &StepContext) {
    let (position_lambdas, packed_position_lambdas) = match &mut pbf.lambdas {
        Lambdas::Full(lambdas) => (Some(lambdas.write()), None),
        Lambdas::Packed(lambdas) => (None, Some(lambdas.write())),
    };
    let (sorted, neighbours) = (&pbf.search.sorted, &pbf.search.neighbours);
    context.slots.dispatch(
        recording,
        &ConstrainDensity {
            variant: ConstrainDensityVariant { walls: context.walls, precision: sorted.precision },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: context.walls.then(|| sorted.positions.read()),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            position_lambdas,
            packed_position_lambdas,
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kernel: pbf.search.smoothing_kernel.uniform(),
            pbf: pbf.params.uniform(),
        },
    );
}
