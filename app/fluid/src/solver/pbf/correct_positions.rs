//! Moves the quantized positions by what the lambdas ask for. (Shader: `solver/pbf/correct_positions.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{Buffer, CorrectPositions, CorrectPositionsVariant};

use super::Pbf;
use crate::step_context::StepContext;

pub(super) fn correct_positions(recording: &mut Recording, pbf: &mut Pbf, context: &mut StepContext, s_corr: bool) {
    let (position_lambdas, packed_position_lambdas) = pbf.lambdas.read();
    let (sorted, neighbours) = (&mut pbf.search.sorted, &pbf.search.neighbours);
    let walls = context.boundary();
    let params = context.solids.as_ref().map(|solids| solids.params().alias());
    let solids_params = params.as_ref().map(Buffer::uniform);
    let solid_contacts = context.solids.as_mut().map(|solids| solids.contacts_mut().write());
    context.slots.dispatch(
        recording,
        &CorrectPositions {
            variant: CorrectPositionsVariant { walls, s_corr, precision: sorted.precision },
            position_lambdas,
            packed_position_lambdas,
            sorted_positions: sorted.positions.read(),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            solid_contacts,
            quantized_positions: sorted.quantized_positions.write(),
            counters: context.counters.write(),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kernel: pbf.without_walls.as_ref().unwrap_or(&pbf.search.smoothing_kernel).uniform(),
            pbf: pbf.params.uniform(),
            solids_params,
        },
    );
}
