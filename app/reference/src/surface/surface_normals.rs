//! Normals from the inverse depth.

use super::{InverseDepth, inverse_depth_difference};
use brooklet_kernels::{FrameView, SurfaceParams};
use glam::DVec3;

/// Unit normals toward the eye, in world axes; `None` where no fluid is. (Shader:
/// `surface/normal.hlsli`.)
pub fn surface_normals(from: &InverseDepth, params: &SurfaceParams, view: &FrameView) -> Vec<Option<DVec3>> {
    let [width, height] = from.size_px;
    let tan = [view.tan_half_width, view.tan_half_height].map(f64::from);
    let axis = |axis: [f32; 3]| DVec3::from_array(axis.map(f64::from));
    let normal = |x: i64, y: i64| {
        let here = from.at(x, y);
        let same = inverse_depth_difference(params.range_m, here);
        let slope_x = slope(from.at(x - 1, y), here, from.at(x + 1, y), same);
        let slope_y = -slope(from.at(x, y - 1), here, from.at(x, y + 1), same);
        let gradient = [slope_x * 0.5 * width as f64 / tan[0], slope_y * 0.5 * height as f64 / tan[1]];
        let ray = [
            ((x as f64 + 0.5) / width as f64 * 2.0 - 1.0) * tan[0],
            (1.0 - (y as f64 + 0.5) / height as f64 * 2.0) * tan[1],
        ];
        let ahead = here - gradient[0] * ray[0] - gradient[1] * ray[1];
        -(gradient[0] * axis(view.right) + gradient[1] * axis(view.up) + ahead * axis(view.forward)).normalize()
    };
    let pixels = from.values.iter().enumerate();
    pixels.map(|(i, &here)| (here > 0.0).then(|| normal((i % width) as i64, (i / width) as i64))).collect()
}

/// Central where both neighbours are of one surface, else the smaller one-sided difference.
pub(crate) fn slope(before: f64, here: f64, after: f64, same: f64) -> f64 {
    let backward = (before > 0.0).then_some(here - before);
    let forward = (after > 0.0).then_some(after - here);
    match (backward, forward) {
        (Some(backward), Some(forward)) if backward.abs().max(forward.abs()) < same => 0.5 * (backward + forward),
        (Some(backward), Some(forward)) if backward.abs() < forward.abs() => backward,
        (_, Some(forward)) => forward,
        (Some(backward), None) => backward,
        (None, None) => 0.0,
    }
}
