//! XSPH viscosity. (Shader: `forces/xsph.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{Buffer, ForceParams, Velocity, Xsph, XsphVariant};

use crate::grid::NeighbourSearch;
use crate::step_context::StepContext;

pub(super) fn xsph(
    recording: &mut Recording,
    params: &Buffer<ForceParams>,
    context: &StepContext,
    search: &NeighbourSearch,
    velocities: &Buffer<Velocity>,
    smoothed: &mut Buffer<Velocity>,
) {
    context.slots.dispatch(
        recording,
        &Xsph {
            variant: XsphVariant { precision: search.sorted.precision },
            quantized_positions: search.sorted.quantized_positions.read(),
            velocities: velocities.read(),
            neighbours: search.neighbours.deltas.read(),
            list_heads: search.neighbours.heads.read(),
            smoothed_velocities: smoothed.write(),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kernel: search.smoothing_kernel.uniform(),
            forces: params.uniform(),
        },
    );
}
