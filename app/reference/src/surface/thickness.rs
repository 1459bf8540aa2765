//! How much fluid the eye and the sun look through, in spacings.

use super::sun_map::{SunMap, world_from_shadow};
use super::surface_normals::{plane_from_slopes, slope};
use super::{InverseDepth, inverse_depth_difference};
use brooklet_kernels::{FrameLight, FrameView, SurfaceParams};
use glam::{DVec2, DVec3, DVec4};

/// What a particle adds at `squared`, the square of the distance from its disc's middle over its radius: its
/// volume d^3 spread as (1 - s)^2. (Shader: `surface/thickness_kernel.hlsli`.)
fn thickness_kernel(squared: f64, params: &SurfaceParams) -> f64 {
    let ratio = f64::from(params.spacing_m) / f64::from(params.thickness_radius_m);
    3.0 / std::f64::consts::PI * ratio * ratio * (1.0 - squared).max(0.0).powi(2)
}

/// Along the rays of a picture's pixels, before the planes of [`opaque_planes`]. (Shader: `surface/thickness.hlsl`.)
pub fn thickness(
    centers_m: &[DVec3],
    params: &SurfaceParams,
    view: &FrameView,
    size_px: [usize; 2],
    planes: &[DVec4],
) -> Vec<f64> {
    let eye_m = DVec3::from_array(view.eye_m.map(f64::from));
    let radius_m2 = f64::from(params.thickness_radius_m).powi(2);
    let through = |(index, plane): (usize, &DVec4)| {
        let ray = super::ray_of(view, size_px, index, DVec2::ZERO).normalize();
        let of = |center_m: &DVec3| {
            let center_m = *center_m - eye_m;
            let distance_m2 = center_m.length_squared();
            let along_m = center_m.dot(ray);
            // Outside, and ahead of the eye: tangents of the angles from the disc's middle and to its rim.
            if distance_m2 <= radius_m2 || along_m <= 0.0 {
                return 0.0;
            }
            let tan2 = (distance_m2 - along_m * along_m) / (along_m * along_m);
            // Those behind fade within half a spacing.
            let before = (1.0 + plane.w - plane.truncate().dot(center_m)).clamp(0.0, 1.0);
            thickness_kernel(tan2 * (distance_m2 - radius_m2) / radius_m2, params)
                * (before * before * (3.0 - 2.0 * before))
        };
        centers_m.iter().map(of).sum()
    };
    planes.iter().enumerate().map(through).collect()
}

/// The planes N . x = c, x relative to the eye, that touch the opaque things whose inverse depth `scene` is, in each of
/// `size_px` texels: N and c over |N| times half a spacing. (Shader: `surface/opaque_planes.hlsl`.)
pub fn opaque_planes(
    scene: &InverseDepth,
    params: &SurfaceParams,
    view: &FrameView,
    size_px: [usize; 2],
) -> Vec<DVec4> {
    let plane = |index: usize| {
        let texel = [index % size_px[0], index / size_px[0]];
        let [x, y] = [0, 1].map(|i| ((texel[i] as f64 + 0.5) / size_px[i] as f64 * scene.size_px[i] as f64) as i64);
        let here = scene.at(x, y);
        if here <= 0.0 {
            return DVec4::W;
        }
        let same = inverse_depth_difference(params.range_m, here);
        let slopes = [
            slope(scene.at(x - 1, y), here, scene.at(x + 1, y), same),
            -slope(scene.at(x, y - 1), here, scene.at(x, y + 1), same),
        ];
        let plane = plane_from_slopes(view, scene.size_px, [x, y], here, slopes);
        plane.extend(1.0) / (plane.length() * 0.5 * f64::from(params.spacing_m))
    };
    (0..size_px[0] * size_px[1]).map(plane).collect()
}

/// Along the sun's rays, in a map of `texels` a side. (Shader: `surface/sun_thickness.hlsl`.)
pub fn sun_thickness(centers_m: &[DVec3], params: &SurfaceParams, light: &FrameLight, texels: usize) -> SunMap {
    let to_sun = DVec3::from_array(light.to_sun.map(f64::from));
    let empty = SunMap { side: texels, values: Vec::new() };
    let through = |(x, y): (i64, i64)| {
        let [u, v] = [x, y].map(|at| (at as f64 + 0.5) / texels as f64);
        let from_m = world_from_shadow(light, DVec3::new(u, v, 0.0));
        let of = |center_m: &DVec3| {
            let apart_m = *center_m - from_m;
            let aside_m2 = (apart_m - apart_m.dot(to_sun) * to_sun).length_squared();
            thickness_kernel(aside_m2 / f64::from(params.thickness_radius_m).powi(2), params)
        };
        centers_m.iter().map(of).sum()
    };
    SunMap { side: texels, values: empty.texels().map(through).collect() }
}
