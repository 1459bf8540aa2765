//! Particles sorted into bins that fit the mesh's cells: a counting sort with the scan there is.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, CountBins, MeshParams, Position, ScatterBins};

use super::scanned;
use crate::surface::Particles;

/// Particles, bin after bin.
pub(super) struct Bins {
    /// Where each bin begins among them, and what ends the last.
    pub starts: Buffer<u32>,
    /// The particles; a tag is the slot's number.
    pub particles: Buffer<Position>,
}

/// Records the sort.
pub(super) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    particles: &Particles<'_>,
    (mesh, params): (&Buffer<MeshParams>, &MeshParams),
) -> Bins {
    let slots = particles.slots;
    // One more for what takes no part, and one to end it.
    let mut counts = resources.buffer("bin_counts", params.bin_count + 2);
    let mut bin_slots = resources.buffer("bin_slots", slots.capacity);
    recording.clear(&mut counts);
    slots.dispatch(
        recording,
        &CountBins {
            positions: particles.positions.read(),
            bin_counts: counts.write(),
            bin_slots: bin_slots.write(),
            step_state: slots.state.uniform(),
            mesh: mesh.uniform(),
        },
    );
    let starts = scanned(resources, recording, "bin_starts", &counts);
    let mut sorted = resources.buffer("bin_particles", slots.capacity);
    if slots.capacity == 0 {
        // Nothing else writes it.
        recording.clear(&mut sorted);
    }
    slots.dispatch(
        recording,
        &ScatterBins {
            positions: particles.positions.read(),
            bin_slots: bin_slots.read(),
            bin_starts: starts.read(),
            bin_particles: sorted.write(),
            step_state: slots.state.uniform(),
        },
    );
    Bins { starts, particles: sorted }
}
