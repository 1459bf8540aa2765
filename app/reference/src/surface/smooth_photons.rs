//! Where photons land, without the particles' pattern.

use super::refract_photons::{Photon, smooth_step};
use super::sun_map::{SunMap, entry_at, is_same_surface, photon_spacing_m};
use super::{Along, middle_weight, spatial_weight};
use brooklet_kernels::{FrameLight, SurfaceParams};
use glam::DVec2;

/// Reach over the spacing, two standard deviations.
const REACH: f64 = 2.0;
/// Share of a window up to which a photon keeps its place.
const OUTLINE: f64 = 0.5;

/// One pass. (Shader: `surface/smooth_photons.compute`.)
pub fn smooth_photons(
    photons: &[Photon],
    sun_depth: &SunMap,
    params: &SurfaceParams,
    light: &FrameLight,
    along: Along,
) -> Vec<Photon> {
    let photon_m = photon_spacing_m(params, light);
    let reach = (REACH * f64::from(params.spacing_m) / photon_m).min(f64::from(params.most_reach_px));
    // It has no pass over both directions at once.
    let (dx, dy) = if along == Along::Y { (0, 1) } else { (1, 0) };
    let side = sun_depth.side as i64;
    let is_free =
        |x: i64, y: i64| sun_depth.at(x, y) > 0.0 && !entry_at(params, light, x, y).is_wall(sun_depth.at(x, y));
    let moved = |x: i64, y: i64| {
        let photon = photons[(y * side + x) as usize];
        (photon, photon.uv - DVec2::new(x as f64, y as f64) / f64::from(params.photons))
    };
    let smoothed = |(x, y): (i64, i64)| {
        let (photon, aside) = moved(x, y);
        if !is_free(x, y) {
            return photon;
        }
        let mut window = middle_weight();
        let mut sums =
            (middle_weight(), middle_weight() * aside, middle_weight() * DVec2::new(photon.path_m, photon.share));
        for i in (-(reach as i64)..=reach as i64).filter(|&i| i != 0) {
            let (u, v) = (x + i * dx, y + i * dy);
            let weight = spatial_weight((i * i) as f64, reach);
            window += weight;
            if is_same_surface(sun_depth, params, light, [x, y], [u, v]) {
                let (other, aside) = moved(u, v);
                sums.0 += weight;
                sums.1 += weight * aside;
                sums.2 += weight * DVec2::new(other.path_m, other.share);
            }
        }
        let evens = smooth_step(OUTLINE, 1.0, sums.0 / window);
        let uv = photon.uv + evens * (sums.1 / sums.0 - aside);
        let path_and_share = DVec2::new(photon.path_m, photon.share).lerp(sums.2 / sums.0, evens);
        Photon { uv, path_m: path_and_share.x, share: path_and_share.y }
    };
    sun_depth.texels().map(smoothed).collect()
}
