//! Particles sorted into bins that fit the mesh's cells: a counting sort with the scan there is.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buf, Buffer, CountBins, CountBinsVariant, Ellipsoid, MeshKernel, MeshParams, Position, ScatterBins,
    ScatterBinsVariant,
};

use super::scanned;
use crate::surface::Particles;

/// Particles, bin after bin.
pub(super) struct Bins {
    /// Where each bin begins among them, and what ends the last.
    pub starts: Buffer<u32>,
    /// The particles, or what their ellipsoids add to the field.
    pub contents: Contents,
}

/// What bins hold.
pub(super) enum Contents {
    Particles(Buffer<Position>),
    Kernels(Buffer<MeshKernel>),
}

impl Contents {
    pub fn particles(&self) -> Option<Buf<'_, Position>> {
        match self {
            Self::Particles(particles) => Some(particles.read()),
            Self::Kernels(_) => None,
        }
    }

    pub fn kernels(&self) -> Option<Buf<'_, MeshKernel>> {
        match self {
            Self::Particles(_) => None,
            Self::Kernels(kernels) => Some(kernels.read()),
        }
    }
}

/// Records the sort.
pub(super) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    (particles, ellipsoids): (&Particles<'_>, Option<&Buffer<Ellipsoid>>),
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
            variant: CountBinsVariant { anisotropic: ellipsoids.is_some() },
            positions: ellipsoids.is_none().then(|| particles.positions.read()),
            ellipsoids: ellipsoids.map(Buffer::read),
            bin_counts: counts.write(),
            bin_slots: bin_slots.write(),
            step_state: slots.state.uniform(),
            mesh: mesh.uniform(),
        },
    );
    let starts = scanned(resources, recording, "bin_starts", &counts);
    let mut contents = match ellipsoids {
        Some(_) => Contents::Kernels(resources.buffer("bin_kernels", slots.capacity.max(1))),
        None => Contents::Particles(resources.buffer("bin_particles", slots.capacity)),
    };
    if slots.capacity == 0 {
        // Nothing else writes them.
        match &mut contents {
            Contents::Particles(particles) => recording.clear(particles),
            Contents::Kernels(kernels) => recording.clear(kernels),
        }
    }
    let (bin_particles, bin_kernels) = match &mut contents {
        Contents::Particles(particles) => (Some(particles.write()), None),
        Contents::Kernels(kernels) => (None, Some(kernels.write())),
    };
    slots.dispatch(
        recording,
        &ScatterBins {
            variant: ScatterBinsVariant { anisotropic: ellipsoids.is_some() },
            positions: ellipsoids.is_none().then(|| particles.positions.read()),
            ellipsoids: ellipsoids.map(Buffer::read),
            bin_slots: bin_slots.read(),
            bin_starts: starts.read(),
            bin_particles,
            bin_kernels,
            step_state: slots.state.uniform(),
            mesh: ellipsoids.map(|_| mesh.uniform()),
        },
    );
    Bins { starts, contents }
}
