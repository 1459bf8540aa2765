//! λ of each particle. (Shader: `solver/pbf/constrain_density.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{ConstrainDensity, ConstrainDensityVariant, MomentumKeyword, WallsKeyword};

use super::{CoarseCorrection, Momentum, Pbf};
use crate::step_context::StepContext;

/// From quantized positions to `pbf.lambdas`, in the substep's iteration of a number.
pub(super) fn constrain_density(recording: &mut Recording, pbf: &mut Pbf, context: &StepContext, iteration: usize) {
    let (momentum, weights, lambda_totals, coarse) = match &mut pbf.momentum {
        None => (MomentumKeyword::Off, None, None, None),
        Some(Momentum { accumulates: false, weights, .. }) => (MomentumKeyword::Momentum, Some(weights), None, None),
        Some(Momentum { weights, totals, coarse, .. }) => {
            let coarse = coarse.as_mut().filter(|_| iteration == 0).map(CoarseCorrection::finest);
            let keyword = match coarse {
                Some(_) => MomentumKeyword::RestrictedMomentum,
                None => MomentumKeyword::AccumulatedMomentum,
            };
            (keyword, Some(weights), totals.as_mut().map(|totals| totals.write()), coarse)
        }
    };
    let (coarse_cells, coarse) = coarse.map(|(cells, params)| (cells.write(), params.uniform())).unzip();
    let (position_lambdas, packed_position_lambdas) = pbf.lambdas.write();
    let (sorted, neighbours) = (&pbf.search.sorted, &pbf.search.neighbours);
    let walls = context.boundary();
    context.slots.dispatch(
        recording,
        &ConstrainDensity {
            variant: ConstrainDensityVariant { walls, momentum, precision: sorted.precision },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: (walls != WallsKeyword::Off || coarse.is_some()).then(|| sorted.positions.read()),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            solid_contacts: context.solids.as_ref().map(|solids| solids.contacts().read()),
            position_lambdas,
            packed_position_lambdas,
            lambda_totals,
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kernel: pbf.search.smoothing_kernel.uniform(),
            pbf: pbf.params.uniform(),
            coarse_cells,
            coarse,
            iteration: weights.map(|weights| weights[iteration].uniform()),
        },
    );
}
