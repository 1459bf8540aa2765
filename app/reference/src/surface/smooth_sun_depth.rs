//! The surface that sunlight meets, without the particles' bumps.

use super::sun_map::{SunMap, photon_spacing_m};
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
        let (mut sum, mut weights) = (middle_weight() * here, middle_weight());
        for i in 1..=reach as i64 {
            let (before, after) = (from.at(x - i * dx, y - i * dy), from.at(x + i * dx, y + i * dy));
            let range = (f64::from(params.range_m) + 2.0 * i as f64 * spacing_m) / f64::from(light.shadow_range_m);
            if before.min(after) > 0.0 && (before - here).abs().max((after - here).abs()) < range {
                let weight = spatial_weight((i * i) as f64, reach);
                sum += weight * (before + after);
                weights += 2.0 * weight;
            }
        }
        sum / weights
    };
    SunMap { side: from.side, values: from.texels().map(|(x, y)| smoothed(x, y)).collect() }
}
