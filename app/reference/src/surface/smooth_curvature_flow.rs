//! Screen-space curvature flow (van der Laan, Green & Sainz 2009).

use super::{InverseDepth, inverse_depth_difference};
use brooklet_kernels::{FrameView, SurfaceParams};

/// One step. (Shader: `surface/smooth_curvature_flow.hlsl`.)
pub fn smooth_curvature_flow(from: &InverseDepth, params: &SurfaceParams, view: &FrameView) -> InverseDepth {
    let angle = f64::from(view.pixel_angle);
    from.map(|x, y, here| {
        let z = 1.0 / here;
        let p = z * angle;
        let range = inverse_depth_difference(params.range_m, here);
        let at = |dx: i64, dy: i64| {
            let there = from.at(x + dx, y + dy);
            if there > 0.0 && (there - here).abs() < range { 1.0 / there } else { z }
        };
        let zx = 0.5 * (at(1, 0) - at(-1, 0));
        let zy = 0.5 * (at(0, 1) - at(0, -1));
        let zxx = at(1, 0) - 2.0 * z + at(-1, 0);
        let zyy = at(0, 1) - 2.0 * z + at(0, -1);
        let zxy = 0.25 * ((at(1, 1) - at(-1, 1)) - (at(1, -1) - at(-1, -1)));
        let d = zx * zx + zy * zy + p * p;
        let dx = 2.0 * (zx * zxx + zy * zxy + p * angle * zx);
        let dy = 2.0 * (zx * zxy + zy * zyy + p * angle * zy);
        let (ex, ey) = (zxx * d - 0.5 * zx * dx, zyy * d - 0.5 * zy * dy);
        let moved = (ex + ey) / (d.powf(1.5) * p) * f64::from(params.flow_m2).min(0.22 * p * p);
        let most = f64::from(params.clamp_m);
        1.0 / (z + moved.clamp(-most, most))
    })
}
