//! The particles' ellipsoids (Yu & Turk 2013), made once before the surface is drawn: 32 bytes each.
//! (Shader: `surface/anisotropy.compute`.)
//!
//! An ellipsoid's center moves by what the neighbours' mean is off more than that of a flat surface. Moved by all of
//! it, water stood half a spacing low and away from its walls.

use brooklet_fluid::grid::Neighbours;
use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Anisotropy, AnisotropyParams, Buffer, Ellipsoid, LIST_SLICE, SurfaceParams};

use super::ScreenSpaceOptions;
use crate::surface::Particles;

/// What the shader is given with lists of `list_chunks` runs.
pub fn params(options: &ScreenSpaceOptions, list_chunks: u32) -> AnisotropyParams {
    AnisotropyParams { support_m: options.support_m as f32, list_chunks, ..AnisotropyParams::default() }
}

/// Records the ellipsoids of `particles` from their `neighbours`, which end at the walls of `surface`. `init` uploads
/// the settings.
pub(super) fn record(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    particles: &Particles<'_>,
    neighbours: &Neighbours,
    surface: &Buffer<SurfaceParams>,
    options: &ScreenSpaceOptions,
) -> Buffer<Ellipsoid> {
    let capacity = particles.slots.capacity;
    // Whole slices of lists, all as long: see `list_length`.
    let list_chunks = neighbours.deltas.len / capacity.next_multiple_of(LIST_SLICE).max(1);
    let mut settings = resources.persistent("anisotropy_params", 1);
    init.upload(&mut settings, &[params(options, list_chunks)]);
    let mut ellipsoids = resources.buffer("ellipsoids", capacity);
    particles.slots.dispatch(
        recording,
        &Anisotropy {
            positions: particles.positions.read(),
            neighbours: neighbours.deltas.read(),
            list_heads: neighbours.heads.read(),
            ellipsoids: ellipsoids.write(),
            step_state: particles.slots.state.uniform(),
            anisotropy: settings.uniform(),
            surface: surface.uniform(),
        },
    );
    ellipsoids
}
