//! How much water sunlight has passed where it meets water: what shades the water's surface below a drop or a column.
//!
//! The particles' volume is counted into a grid over the sun's map and along its rays (`surface/count_sun_volume.compute`)
//! and summed away from the sun (`sum_sun_volume.compute`). The water asks it where it is shaded (`water.hlsl`).

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, CountSunVolume, FrameLight, SumSunVolume, SunVolumeParams};

use crate::surface::Particles;

/// A cell is at least so many spacings: its tents even a lattice out.
const LEAST_CELL_SPACINGS: f32 = 2.0;
/// Cells a side: at most 1 MiB for either of the two buffers.
const CELLS: std::ops::RangeInclusive<u32> = 4..=64;

/// The grid on the GPU.
#[derive(Debug)]
pub struct SunVolume {
    /// Particles' volumes by cell, in `SUN_VOLUME_UNITS`; cells of a ray lie one after the other, the sun's first.
    pub counts: Buffer<u32>,
    /// Water between the sun and the middle of each cell, m.
    pub above_m: Buffer<f32>,
    /// Its settings.
    pub params: Buffer<SunVolumeParams>,
}

/// What the shaders are given for particles `spacing_m` apart under `light`.
pub fn params(spacing_m: f64, light: &FrameLight) -> SunVolumeParams {
    let spacing_m = spacing_m as f32;
    let side_m = light.shadow_texel_m * light.shadow_texels;
    // Saturates: a NaN or a negative number is 0.
    let most = (side_m.min(light.shadow_range_m) / (LEAST_CELL_SPACINGS * spacing_m)) as u32;
    let cells = most.clamp(*CELLS.start(), *CELLS.end());
    SunVolumeParams { cells, spacing_m, cell_m: side_m / cells as f32, ..SunVolumeParams::default() }
}

/// Records the volume of `particles`. `init` uploads the settings.
pub(crate) fn record(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    particles: &Particles<'_>,
    light: &Buffer<FrameLight>,
    values: SunVolumeParams,
) -> SunVolume {
    let mut params = resources.persistent("sun_volume_params", 1);
    init.upload(&mut params, &[values]);
    let cells = values.cells.pow(3);
    let mut counts = resources.buffer("sun_volume_counts", cells);
    recording.clear(&mut counts);
    particles.slots.dispatch(
        recording,
        &CountSunVolume {
            positions: particles.positions.read(),
            sun_volume_counts: counts.write(),
            step_state: particles.slots.state.uniform(),
            light: light.uniform(),
            volume: params.uniform(),
        },
    );
    let mut above_m = resources.buffer("sun_volume", cells);
    recording.dispatch(
        &SumSunVolume { sun_volume_counts: counts.read(), sun_volume: above_m.write(), volume: params.uniform() },
        values.cells.pow(2),
    );
    SunVolume { counts, above_m, params }
}
