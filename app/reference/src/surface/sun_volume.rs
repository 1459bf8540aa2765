//! How much water is nearer the sun, in a grid over its map and along its rays. Cells of a ray lie one after the other,
//! the sun's first.

use super::sun_map::shadow_position;
use brooklet_kernels::{FrameLight, SUN_VOLUME_UNITS, SunVolumeParams};
use glam::DVec3;

/// Where a point lies in the grid, in cells from the middle of the first one. (Shader: `SunCellPosition`.)
fn cell_position(light: &FrameLight, params: &SunVolumeParams, at_m: DVec3) -> DVec3 {
    let at = shadow_position(light, at_m);
    DVec3::new(at.x, at.y, 1.0 - at.z) * f64::from(params.cells) - 0.5
}

fn corners(cells: usize, at: DVec3) -> impl Iterator<Item = (usize, f64)> {
    let low = at.floor();
    let high_share = (at - low).to_array();
    (0..8).map(move |corner| {
        let up = [corner & 1, (corner >> 1) & 1, corner >> 2];
        let share = |axis: usize| if up[axis] == 1 { high_share[axis] } else { 1.0 - high_share[axis] };
        let at = [0, 1, 2].map(|axis| low[axis] as usize + up[axis]);
        ((at[1] * cells + at[0]) * cells + at[2], share(0) * share(1) * share(2))
    })
}

/// The particles' volumes by cell. (Shader: `surface/count_sun_volume.compute`.)
pub fn count_sun_volume(centers_m: &[DVec3], params: &SunVolumeParams, light: &FrameLight) -> Vec<u32> {
    let cells = params.cells as usize;
    let mut counts = vec![0; cells.pow(3)];
    for &center_m in centers_m {
        let at = cell_position(light, params, center_m);
        if at.cmpge(DVec3::ZERO).all() && at.cmplt(DVec3::splat(cells as f64 - 1.0)).all() {
            for (cell, share) in corners(cells, at) {
                counts[cell] += (f64::from(SUN_VOLUME_UNITS) * share + 0.5) as u32;
            }
        }
    }
    counts
}

/// Water between the sun and the middle of each cell, m. (Shader: `surface/sum_sun_volume.compute`.)
pub fn sum_sun_volume(counts: &[u32], params: &SunVolumeParams) -> Vec<f64> {
    let scale_m =
        f64::from(params.spacing_m).powi(3) / (f64::from(SUN_VOLUME_UNITS) * f64::from(params.cell_m).powi(2));
    let mut above_m = Vec::with_capacity(counts.len());
    for ray in counts.chunks(params.cells as usize) {
        let mut before = 0;
        for own in ray {
            above_m.push(scale_m * (f64::from(before) + 0.5 * f64::from(*own)));
            before += own;
        }
    }
    above_m
}

/// Water between the sun and a point of a surface, m. (Shader: `WaterTowardSun` of `surface/water.hlsl`.)
pub fn water_toward_sun(above_m: &[f64], params: &SunVolumeParams, light: &FrameLight, at_m: DVec3) -> f64 {
    let at = cell_position(light, params, at_m) - DVec3::Z;
    let at = at.clamp(DVec3::ZERO, DVec3::splat(f64::from(params.cells) - 1.001));
    corners(params.cells as usize, at).map(|(cell, share)| share * above_m[cell]).sum()
}
