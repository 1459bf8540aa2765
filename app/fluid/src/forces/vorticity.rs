//! Vorticity confinement: one buffer and two passes. (Shaders: `forces/curl.compute`,
//! `forces/confine_vorticity.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, ConfineVorticity, ConfineVorticityVariant, Curl, CurlVariant, ForceParams, Velocity, Vorticity,
};

use crate::grid::NeighbourSearch;
use crate::step_context::StepContext;

pub(super) struct VorticityConfinement {
    vorticities: Buffer<Vorticity>,
}

impl VorticityConfinement {
    pub(super) fn declare(resources: &mut Resources, capacity: u32) -> Self {
        Self { vorticities: resources.buffer("vorticities", capacity) }
    }

    pub(super) fn record(
        &mut self,
        recording: &mut Recording,
        params: &Buffer<ForceParams>,
        context: &StepContext,
        search: &NeighbourSearch,
        velocities: &mut Buffer<Velocity>,
    ) {
        let (sorted, neighbours) = (&search.sorted, &search.neighbours);
        context.slots.dispatch(
            recording,
            &Curl {
                variant: CurlVariant { precision: sorted.precision },
                quantized_positions: sorted.quantized_positions.read(),
                velocities: velocities.read(),
                neighbours: neighbours.deltas.read(),
                list_heads: neighbours.heads.read(),
                vorticities: self.vorticities.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                kernel: search.smoothing_kernel.uniform(),
            },
        );
        context.slots.dispatch(
            recording,
            &ConfineVorticity {
                variant: ConfineVorticityVariant { precision: sorted.precision },
                quantized_positions: sorted.quantized_positions.read(),
                vorticities: self.vorticities.read(),
                neighbours: neighbours.deltas.read(),
                list_heads: neighbours.heads.read(),
                velocities: velocities.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                forces: params.uniform(),
            },
        );
    }
}
