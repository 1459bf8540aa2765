//! Photons bent by the water's surface, and carried to the floor.

use super::spatial_weight;
use super::sun_map::{SunMap, entry_at, photon_spacing_m, rows, shadow_position, world_from_shadow};
use super::surface_normals::slope;
use brooklet_kernels::{FrameLight, SurfaceParams};
use glam::{DVec2, DVec3};

/// Refractive index of water, as the shaders have it.
const AIR_OVER_WATER: f64 = 0.7502;
/// Reflectance of water at normal incidence.
const WATER_F0: f64 = 0.0204;
/// What is nearly the whole way through water is the whole way.
const WHOLE_WAY: f64 = 1.25;
/// Water less than so many spacings thick has no surface to trust, and more than so many has.
const THIN: f64 = 1.5;
const THICK: f64 = 6.0;
/// Share of a surface around a point of it above which it bends light, and from which it does so wholly.
const OUTLINE: f64 = 0.6;
const INSIDE: f64 = 1.0;
/// How far around is looked, in spacings, and in how many steps at most.
const OUTLINE_REACH: f64 = 3.0;
const MOST_STEPS: i64 = 12;
const BINOMIAL: [f64; 5] = [1.0, 4.0, 6.0, 4.0, 1.0];
/// No photon runs flatter than this.
const LEAST_FALL: f64 = 0.05;

/// A ray of sunlight that the water bent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    /// Where in the sun's map lies what it lights on the floor.
    pub uv: DVec2,
    /// How much water it went through, m.
    pub path_m: f64,
    /// Share of it that entered the water; 0 where there is none.
    pub share: f64,
}

/// A photon for each cell of `sun_depth`. `sun_thickness` is in spacings. (Shader:
/// `surface/refract_photons.compute`.)
pub fn refract_photons(
    sun_depth: &SunMap,
    sun_thickness: &SunMap,
    params: &SurfaceParams,
    light: &FrameLight,
) -> Vec<Photon> {
    let to_sun = DVec3::from_array(light.to_sun.map(f64::from));
    let side = f64::from(params.photons);
    let photon = |(x, y): (i64, i64)| {
        let uv = DVec2::new((x as f64 + 0.5) / side, (y as f64 + 0.5) / side);
        let here = sun_depth.at(x, y);
        if here <= 0.0 {
            return Photon { uv, path_m: 0.0, share: 0.0 };
        }
        let mut from_m = world_from_shadow(light, uv.extend(here));
        from_m.y = from_m.y.max(0.0);
        let spacings = even_thickness(sun_thickness, uv, params, light);
        let entry = entry_at(params, light, x, y);
        let (normal, bends) = match entry.is_wall(here) {
            true => (entry.outward, 1.0),
            false => {
                let around = if spacings > THIN { surface_around(sun_depth, params, light, x, y) } else { 0.0 };
                let bends = smooth_step(THIN, THICK, spacings) * smooth_step(OUTLINE, INSIDE, around);
                (normal_toward_sun(sun_depth, params, light, x, y), bends)
            }
        };
        let bent = refract(-to_sun, normal, AIR_OVER_WATER).unwrap_or(-normal);
        let bent = (-to_sun).lerp(bent, bends).normalize();
        let fall = (-bent.y).max(LEAST_FALL);
        let thickness_m = spacings * f64::from(params.spacing_m);
        let wet = (WHOLE_WAY * thickness_m * to_sun.y / from_m.y.max(1e-6)).clamp(0.0, 1.0);
        let height_m = from_m.y * wet;
        let out_m = from_m + bent * (height_m / fall);
        let lit_m = out_m - to_sun * (out_m.y.max(0.0) / to_sun.y);
        let grazing = 1.0 - normal.dot(to_sun).clamp(0.0, 1.0);
        Photon {
            uv: shadow_position(light, lit_m).truncate(),
            path_m: height_m.min(thickness_m * to_sun.y) / fall,
            share: 1.0 - bends * (WATER_F0 + (1.0 - WATER_F0) * grazing.powi(5)),
        }
    };
    sun_depth.texels().map(photon).collect()
}

/// Unit normal toward the sun of a surface that is no wall. A wall ends the surface that meets it.
fn normal_toward_sun(sun_depth: &SunMap, params: &SurfaceParams, light: &FrameLight, x: i64, y: i64) -> DVec3 {
    let here = sun_depth.at(x, y);
    let same = (f64::from(params.range_m) + photon_spacing_m(params, light)) / f64::from(light.shadow_range_m);
    let free = |x: i64, y: i64| {
        let there = sun_depth.at(x, y);
        if entry_at(params, light, x, y).is_wall(there) { 0.0 } else { there }
    };
    let along_u = slope(free(x - 1, y), here, free(x + 1, y), same);
    let along_v = slope(free(x, y - 1), here, free(x, y + 1), same);
    let [u, v, depth] = rows(light).map(|(row, _)| row);
    (depth - f64::from(params.photons) * (along_u * u + along_v * v)).normalize()
}

/// Snell's law; `None` where everything is reflected. `ratio` is the index before over the one behind.
pub fn refract(direction: DVec3, normal: DVec3, ratio: f64) -> Option<DVec3> {
    let cosine = -direction.dot(normal);
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (squared >= 0.0).then(|| ratio * direction + (ratio * cosine - squared.sqrt()) * normal)
}

pub(super) fn smooth_step(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// How much of what is around a cell is not far below it: a Gaussian's share.
fn surface_around(sun_depth: &SunMap, params: &SurfaceParams, light: &FrameLight, x: i64, y: i64) -> f64 {
    let photon_m = photon_spacing_m(params, light);
    let spacing = f64::from(params.spacing_m) / photon_m;
    let apart = (0.4 * spacing).round().max(1.0) as i64;
    let reach = OUTLINE_REACH * spacing;
    let steps = ((reach / apart as f64) as i64).min(MOST_STEPS);
    let (mut same, mut all) = (0.0, 0.0);
    for (i, j) in (-steps..=steps).flat_map(|j| (-steps..=steps).map(move |i| (i, j))) {
        let weight = spatial_weight((apart * apart * (i * i + j * j)) as f64, reach);
        let range_m = f64::from(params.range_m) + 2.0 * photon_m * (apart * i.abs().max(j.abs())) as f64;
        let least = sun_depth.at(x, y) - range_m / f64::from(light.shadow_range_m);
        all += weight;
        if sun_depth.at(x + apart * i, y + apart * j) > least.max(0.0) {
            same += weight;
        }
    }
    if all > 0.0 { same / all } else { 1.0 }
}

/// Thickness without the pattern of the particles.
fn even_thickness(sun_thickness: &SunMap, uv: DVec2, params: &SurfaceParams, light: &FrameLight) -> f64 {
    let texel = 1.0 / f64::from(light.shadow_texels);
    let step = (0.75 * f64::from(params.spacing_m) / f64::from(light.shadow_texel_m)).round().max(1.0) * texel;
    let taps = (0..25).map(|i| (i % 5, i / 5));
    let weighed = taps.map(|(x, y)| {
        let weight = BINOMIAL[x] * BINOMIAL[y];
        weight * sun_thickness.bilinear(uv.x + step * (x as f64 - 2.0), uv.y + step * (y as f64 - 2.0))
    });
    weighed.sum::<f64>() / 256.0
}
