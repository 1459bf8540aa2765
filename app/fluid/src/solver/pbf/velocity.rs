//! From corrections to velocities, and what is done to velocities alone.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, ConfineVorticity, ConfineVorticityVariant, Curl, CurlVariant, PbfParams, Position, UpdateVelocity,
    UpdateVelocityVariant, Velocity, Viscosity, ViscosityVariant, Vorticity,
};

use super::Shared;
use crate::grid::{Neighbours, Sorted};

/// Positions and velocities after the corrections. (Shader: `solver/pbf/update_velocity.compute`.)
pub(super) fn update_velocity(
    recording: &mut Recording,
    shared: &mut Shared,
    sorted: &Sorted,
    positions: &mut Buffer<Position>,
    velocities: &mut Buffer<Velocity>,
) {
    let count = positions.len;
    recording.dispatch(
        &UpdateVelocity {
            variant: UpdateVelocityVariant { packed: sorted.packed, periodic: shared.periodic },
            quantized_positions: sorted.quantized_positions.read(),
            sorted_positions: sorted.positions.read(),
            sorted_velocities: sorted.velocities.read(),
            positions: positions.write(),
            velocities: velocities.write(),
            counters: shared.counters.write(),
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
        },
        count,
    );
}

/// XSPH viscosity. (Shader: `solver/pbf/viscosity.compute`.)
pub(super) fn viscosity(
    recording: &mut Recording,
    pbf: &Buffer<PbfParams>,
    shared: &Shared,
    neighbours: &Neighbours,
    sorted: &Sorted,
    velocities: &Buffer<Velocity>,
    smoothed: &mut Buffer<Velocity>,
) {
    recording.dispatch(
        &Viscosity {
            variant: ViscosityVariant { precision: shared.precision, packed: sorted.packed },
            quantized_positions: sorted.quantized_positions.read(),
            velocities: velocities.read(),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            smoothed_velocities: smoothed.write(),
            step_params: shared.step.uniform(),
            kernel: shared.kernel.uniform(),
            pbf: pbf.uniform(),
        },
        sorted.positions.len,
    );
}

/// Vorticity confinement: its one buffer and two passes.
pub(super) struct Vortices {
    vorticities: Buffer<Vorticity>,
}

impl Vortices {
    pub(super) fn declare(resources: &mut Resources, particle_count: u32) -> Self {
        Self { vorticities: resources.buffer("vorticities", particle_count) }
    }

    /// (Shaders: `solver/pbf/curl.compute`, `solver/pbf/confine_vorticity.compute`.)
    pub(super) fn record(
        &mut self,
        recording: &mut Recording,
        pbf: &Buffer<PbfParams>,
        shared: &Shared,
        neighbours: &Neighbours,
        sorted: &Sorted,
        velocities: &mut Buffer<Velocity>,
    ) {
        recording.dispatch(
            &Curl {
                variant: CurlVariant { precision: shared.precision, packed: sorted.packed },
                quantized_positions: sorted.quantized_positions.read(),
                velocities: velocities.read(),
                neighbours: neighbours.deltas.read(),
                list_heads: neighbours.heads.read(),
                vorticities: self.vorticities.write(),
                step_params: shared.step.uniform(),
                kernel: shared.kernel.uniform(),
            },
            sorted.positions.len,
        );
        recording.dispatch(
            &ConfineVorticity {
                variant: ConfineVorticityVariant { precision: shared.precision, packed: sorted.packed },
                quantized_positions: sorted.quantized_positions.read(),
                vorticities: self.vorticities.read(),
                neighbours: neighbours.deltas.read(),
                list_heads: neighbours.heads.read(),
                velocities: velocities.write(),
                step_params: shared.step.uniform(),
                pbf: pbf.uniform(),
            },
            sorted.positions.len,
        );
    }
}
