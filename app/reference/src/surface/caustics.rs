//! The light that photons bring to the floor.

use super::refract_photons::Photon;
use brooklet_kernels::{FrameLight, SurfaceParams, WaterStyle};
use glam::{DVec2, DVec3};

/// Neighbours that land more cells apart came through another surface; no tent is longer.
const MOST_APART: f64 = 4.0;
/// A tent is no narrower than so many texels.
const LEAST_TEXELS: f64 = 1.0;

/// Light over the sun's map, red, green and blue, rows from the top, `light.shadow_texels` a side. (Shader:
/// `surface/caustics.hlsl`.)
pub fn caustics(photons: &[Photon], params: &SurfaceParams, light: &FrameLight, water: &WaterStyle) -> Vec<DVec3> {
    spread(photons, params, light, water, 0.0, |tent_at| tent_at(DVec2::ZERO))
}

/// How far that light may be off at each texel where a device moves the corners of each tent by up to `aside` of a texel
/// along both axes.
pub fn caustics_doubt(
    photons: &[Photon],
    params: &SurfaceParams,
    light: &FrameLight,
    water: &WaterStyle,
    aside: f64,
) -> Vec<DVec3> {
    let corners = [DVec2::ONE, DVec2::new(1.0, -1.0), DVec2::new(-1.0, 1.0), DVec2::NEG_ONE];
    spread(photons, params, light, water, aside, |tent_at| {
        let here = tent_at(DVec2::ZERO);
        corners.iter().map(|corner| (tent_at(aside * *corner) - here).abs()).fold(0.0, f64::max)
    })
}

/// Adds up what `share` makes of each photon's tent at each texel that it reaches, or would `aside` of where it is; it
/// gets the tent's height as of a distance in texels from there.
fn spread(
    photons: &[Photon],
    params: &SurfaceParams,
    light: &FrameLight,
    water: &WaterStyle,
    aside: f64,
    share: impl Fn(&dyn Fn(DVec2) -> f64) -> f64,
) -> Vec<DVec3> {
    let (side, texels) = (params.photons as i64, light.shadow_texels as usize);
    let absorption = DVec3::from_array(water.absorption_per_m.map(f64::from));
    let spacing = 1.0 / side as f64;
    let mut map = vec![DVec3::ZERO; texels * texels];
    for (index, photon) in photons.iter().enumerate().filter(|(_, photon)| photon.share > 0.0) {
        let at = (index as i64 % side, index as i64 / side);
        let [along_u, along_v] = footprint(photons, side, at, LEAST_TEXELS / texels as f64);
        let area = along_u.perp_dot(along_v).abs();
        let color = (-absorption * photon.path_m).exp() * (photon.share * spacing * spacing / area);
        let reach = along_u.abs() + along_v.abs() + aside / texels as f64;
        let [low, high] = [photon.uv - reach, photon.uv + reach].map(|corner| corner * texels as f64);
        for y in low.y.max(0.0) as usize..(high.y.max(0.0) as usize + 1).min(texels) {
            for x in low.x.max(0.0) as usize..(high.x.max(0.0) as usize + 1).min(texels) {
                let middle = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                let tent_at = |moved: DVec2| {
                    let offset = (middle + moved) / texels as f64 - photon.uv;
                    let tent = [
                        offset.perp_dot(along_v) / along_u.perp_dot(along_v),
                        along_u.perp_dot(offset) / along_u.perp_dot(along_v),
                    ];
                    let [u, v] = tent.map(|t| (1.0 - t.abs()).max(0.0));
                    u * v
                };
                map[y * texels + x] += color * share(&tent_at);
            }
        }
    }
    map
}

/// The parallelogram that a photon and its neighbours make where they land, at least as wide as `least`.
fn footprint(photons: &[Photon], side: i64, at: (i64, i64), least: f64) -> [DVec2; 2] {
    let spacing = 1.0 / side as f64;
    let here = photons[(at.1 * side + at.0) as usize];
    let landed = |dx: i64, dy: i64| {
        let (x, y) = (at.0 + dx, at.1 + dy);
        let inside = x >= 0 && y >= 0 && x < side && y < side;
        let there = inside.then(|| photons[(y * side + x) as usize]).filter(|there| there.share > 0.0);
        there.map(|there| there.uv - here.uv)
    };
    let most = MOST_APART * spacing;
    let offset = |dx: i64, dy: i64| {
        let (before, after) = (landed(-dx, -dy).map(|apart| -apart), landed(dx, dy));
        let apart = match (before, after) {
            (Some(before), Some(after)) if before.length().max(after.length()) < most => 0.5 * (before + after),
            (Some(before), Some(after)) if before.length() < after.length() => before,
            (_, Some(one)) | (Some(one), None) => one,
            (None, None) => DVec2::new(dx as f64, dy as f64) * spacing,
        };
        apart.clamp_length_max(most)
    };
    let (along_u, along_v) = (offset(1, 0), offset(0, 1));
    let axis = along_u.normalize_or(DVec2::X);
    let height = axis.perp_dot(along_v);
    let signed = if height < 0.0 { -1.0 } else { 1.0 };
    [axis * along_u.length().max(least), along_v.dot(axis) * axis + axis.perp() * (signed * height.abs().max(least))]
}
