//! The bilateral filter (Tomasi & Manduchi 1998) over the fluid's pixels.

use super::{Along, InverseDepth, inverse_depth_difference, middle_weight, reach_px, spatial_weight};
use brooklet_kernels::{FrameView, SurfaceParams};

/// One pass. (Shader: `surface/smooth_bilateral.hlsl`.)
pub fn smooth_bilateral(from: &InverseDepth, params: &SurfaceParams, view: &FrameView, along: Along) -> InverseDepth {
    from.map(|x, y, here| {
        let reach = reach_px(params, view, here);
        let range = inverse_depth_difference(params.range_m, here);
        let most = reach as i64;
        let (across, down) = match along {
            Along::X => (most, 0),
            Along::Y => (0, most),
            Along::Plane => (most, most),
        };
        let (mut sum, mut weights) = (middle_weight() * here, middle_weight());
        for dy in -down..=down {
            for dx in -across..=across {
                let squared = (dx * dx + dy * dy) as f64;
                let there = from.at(x + dx, y + dy);
                if (dx, dy) != (0, 0) && squared <= reach * reach && there > 0.0 {
                    let difference = (there - here) / range;
                    let weight = spatial_weight(squared, reach) * (-0.5 * difference * difference).exp();
                    sum += weight * there;
                    weights += weight;
                }
            }
        }
        sum / weights
    })
}
