//! The nearest of all particles' spheres.

use super::{InverseDepth, ray_of};
use brooklet_kernels::{FrameView, SurfaceParams};
use glam::{DVec2, DVec3};

/// InverseDepth along rays `aside` of the middles of a picture's pixels, in pixels, cut off at the tank. (Shader:
/// `surface/fluid_depth.hlsl`.)
pub fn fluid_depth(centers_m: &[DVec3], params: &SurfaceParams, view: &FrameView, aside: DVec2) -> InverseDepth {
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let (eye_m, radius_m) = (vector(view.eye_m), f64::from(params.radius_m));
    let size_px = view.size_px.map(|side| side as usize);
    let nearest = |index: usize| {
        let ray = ray_of(view, size_px, index, aside);
        let (a, b) = ((vector(params.wall_min_m) - eye_m) / ray, (vector(params.wall_max_m) - eye_m) / ray);
        let (enter_box, leave_box) = (a.min(b).max_element(), a.max(b).min_element());
        let of = |center_m: &DVec3| {
            let center_m = *center_m - eye_m;
            let middle = center_m.dot(ray) / ray.length_squared();
            let half = (radius_m * radius_m - (center_m - middle * ray).length_squared()).sqrt() / ray.length();
            let (enter, leave) = ((middle - half).max(enter_box), (middle + half).min(leave_box));
            // Off the sphere `half` is NaN; from inside of it, it is not drawn.
            (enter <= leave && middle - half > 0.0).then_some(1.0 / enter)
        };
        centers_m.iter().filter_map(of).fold(0.0, f64::max)
    };
    InverseDepth { size_px, values: (0..size_px[0] * size_px[1]).map(nearest).collect() }
}
