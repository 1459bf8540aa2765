//! The surface that sunlight meets, of spheres.

use super::sun_map::{SunMap, shadow_position, world_from_shadow};
use brooklet_kernels::{FrameLight, SurfaceParams};
use glam::{DVec2, DVec3};

/// Shadow depth at each cell of the photons' grid, by parallel rays `aside` of the cells' middles, in cells.
/// (Shader: `surface/sun_depth.hlsl`.)
pub fn sun_depth(centers_m: &[DVec3], params: &SurfaceParams, light: &FrameLight, aside: DVec2) -> SunMap {
    let side = params.photons as usize;
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let (to_sun, radius_m) = (vector(light.to_sun), f64::from(params.radius_m));
    let (low_m, high_m) = (vector(params.wall_min_m), vector(params.wall_max_m));
    let along_ray = |x: i64, y: i64| {
        let uv = (DVec2::new(x as f64 + 0.5, y as f64 + 0.5) + aside) / side as f64;
        let from_m = world_from_shadow(light, uv.extend(0.0));
        let (a, b) = ((low_m - from_m) / to_sun, (high_m - from_m) / to_sun);
        let (bottom_m, top_m) = (a.min(b).max_element(), a.max(b).min_element());
        let heights = centers_m.iter().filter_map(|&center_m| {
            let middle_m = (center_m - from_m).dot(to_sun);
            let aside_m2 = (center_m - from_m - middle_m * to_sun).length_squared();
            let rise_m2 = radius_m * radius_m - aside_m2;
            let rise_m = rise_m2.max(0.0).sqrt();
            let height_m = (middle_m + rise_m).min(top_m);
            (rise_m2 >= 0.0 && height_m >= (middle_m - rise_m).max(bottom_m)).then_some(height_m)
        });
        let highest_m = heights.fold(f64::NEG_INFINITY, f64::max);
        if highest_m.is_finite() { shadow_position(light, from_m + highest_m * to_sun).z } else { 0.0 }
    };
    let empty = SunMap { side, values: Vec::new() };
    SunMap { side, values: empty.texels().map(|(x, y)| along_ray(x, y)).collect() }
}
