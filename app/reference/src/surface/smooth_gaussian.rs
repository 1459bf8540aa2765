//! A plain Gaussian over the fluid's pixels.

use super::{Along, InverseDepth, middle_weight, reach_px, spatial_weight};
use brooklet_kernels::{FrameView, SurfaceParams};

/// One pass along a direction. (Shader: `surface/smooth_gaussian.hlsl`, which has no plane.)
pub fn smooth_gaussian(from: &InverseDepth, params: &SurfaceParams, view: &FrameView, along: Along) -> InverseDepth {
    from.map(|x, y, here| {
        let reach = reach_px(params, view, here);
        let (mut sum, mut weights) = (middle_weight() * here, middle_weight());
        for i in 1..=reach as i64 {
            let weight = spatial_weight((i * i) as f64, reach);
            for side in [-i, i] {
                let there = if along == Along::X { from.at(x + side, y) } else { from.at(x, y + side) };
                if there > 0.0 {
                    sum += weight * there;
                    weights += weight;
                }
            }
        }
        sum / weights
    })
}
