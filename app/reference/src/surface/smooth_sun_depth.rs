//! The surface that sunlight meets, without the particles' bumps.

use super::sun_map::{SunMap, entry_at, is_same_surface, photon_spacing_m};
use super::{Along, middle_weight, spatial_weight};
use brooklet_kernels::{FrameLight, SurfaceParams};

/// One pass. (Shader: `surface/smooth_sun_depth.hlsl`.)
pub fn smooth_sun_depth(from: &SunMap, params: &SurfaceParams, light: &FrameLight, along: Along) -> SunMap {
    let spacing_m = photon_spacing_m(params, light);
    let reach = (f64::from(params.sun_smoothing_m) / spacing_m).min(f64::from(params.most_reach_px));
    // It has no pass over both directions at once.
    let (dx, dy) = if along == Along::Y { (0, 1) } else { (1, 0) };
    let smoothed = |x: i64, y: i64| {
        let here = from.at(x, y);
        if here <= 0.0 {
            return 0.0;
        }
        let entry = entry_at(params, light, x, y);
        if entry.is_wall(here) {
            return entry.depth;
        }
        // Least squares: sums of w, w i, w i^2, and of w and w i times what is above `here`.
        let (mut weights, mut above) = ([middle_weight(), 0.0, 0.0], [0.0; 2]);
        for i in (-(reach as i64)..=reach as i64).filter(|&i| i != 0) {
            let (u, v) = (x + i * dx, y + i * dy);
            if is_same_surface(from, params, light, [x, y], [u, v]) {
                let there = from.at(u, v);
                let (weight, i) = (spatial_weight((i * i) as f64, reach), i as f64);
                weights = [weights[0] + weight, weights[1] + weight * i, weights[2] + weight * i * i];
                above = [above[0] + weight * (there - here), above[1] + weight * i * (there - here)];
            }
        }
        let spread = weights[0] * weights[2] - weights[1] * weights[1];
        let fit = if spread > 0.0 { (above[0] * weights[2] - above[1] * weights[1]) / spread } else { 0.0 };
        (here + fit).min(entry.depth)
    };
    SunMap { side: from.side, values: from.texels().map(|(x, y)| smoothed(x, y)).collect() }
}
