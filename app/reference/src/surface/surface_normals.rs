//! Normals from the inverse depth.

use super::{InverseDepth, inverse_depth_difference};
use brooklet_kernels::{FrameView, SurfaceParams};
use glam::DVec3;

/// Unit normals toward the eye, in world axes; `None` where no fluid is. (Shader:
/// `surface/normal.hlsli`.)
pub fn surface_normals(from: &InverseDepth, params: &SurfaceParams, view: &FrameView) -> Vec<Option<DVec3>> {
    let width = from.size_px[0];
    let normal = |x: i64, y: i64| {
        let here = from.at(x, y);
        let same = inverse_depth_difference(params.range_m, here);
        let slope_x = slope(from.at(x - 1, y), here, from.at(x + 1, y), same);
        let slope_y = -slope(from.at(x, y - 1), here, from.at(x, y + 1), same);
        -plane_from_slopes(view, from.size_px, [x, y], here, [slope_x, slope_y]).normalize()
    };
    let pixels = from.values.iter().enumerate();
    pixels.map(|(i, &here)| (here > 0.0).then(|| normal((i % width) as i64, (i / width) as i64))).collect()
}

/// N / c of the plane N . x = c, x relative to the eye, whose inverse depth is `here` at a pixel and grows by `slopes`
/// to the next one, rightward and upward.
pub(crate) fn plane_from_slopes(
    view: &FrameView,
    size_px: [usize; 2],
    pixel: [i64; 2],
    here: f64,
    slopes: [f64; 2],
) -> DVec3 {
    let [width, height] = size_px.map(|side| side as f64);
    let tan = [view.tan_half_width, view.tan_half_height].map(f64::from);
    let axis = |axis: [f32; 3]| DVec3::from_array(axis.map(f64::from));
    let gradient = [slopes[0] * 0.5 * width / tan[0], slopes[1] * 0.5 * height / tan[1]];
    let ray = [
        ((pixel[0] as f64 + 0.5) / width * 2.0 - 1.0) * tan[0],
        (1.0 - (pixel[1] as f64 + 0.5) / height * 2.0) * tan[1],
    ];
    let ahead = here - gradient[0] * ray[0] - gradient[1] * ray[1];
    gradient[0] * axis(view.right) + gradient[1] * axis(view.up) + ahead * axis(view.forward)
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
