//! The narrow-range filter (Truong & Yuksel 2018).

use super::{Along, InverseDepth, inverse_depth_difference, middle_weight, reach_px, spatial_weight};
use brooklet_kernels::{FrameView, SurfaceParams};

/// Pixels that the filter of two dimensions reaches.
const PLANE_PX: i64 = 4;

/// One pass. (Shader: `surface/smooth_narrow_range.hlsl`.)
pub fn smooth_narrow_range(
    from: &InverseDepth,
    params: &SurfaceParams,
    view: &FrameView,
    along: Along,
) -> InverseDepth {
    from.map(|x, y, here| {
        let reach = reach_px(params, view, here);
        let taps: Vec<(i64, i64, f64)> = match along {
            Along::X => (1..=reach as i64).map(|i| (i, 0, spatial_weight((i * i) as f64, reach))).collect(),
            Along::Y => (1..=reach as i64).map(|i| (0, i, spatial_weight((i * i) as f64, reach))).collect(),
            Along::Plane => {
                let small = reach.min(PLANE_PX as f64);
                if small < 1.0 {
                    return here;
                }
                let all = (0..=PLANE_PX).flat_map(|dy| (-PLANE_PX..=PLANE_PX).map(move |dx| (dx, dy)));
                all.filter(|&(dx, dy)| dy > 0 || dx > 0)
                    .map(|(dx, dy)| (dx, dy, spatial_weight((dx * dx + dy * dy) as f64, small + 1.0)))
                    .collect()
            }
        };
        let step = inverse_depth_difference(params.range_m, here);
        let behind = here - inverse_depth_difference(params.clamp_m, here);
        let (mut low, mut high) = (here - step, here + step);
        let (mut sum, mut weights) = (middle_weight() * here, middle_weight());
        for (dx, dy, weight) in taps {
            let pair = [from.at(x - dx, y - dy), from.at(x + dx, y + dy)];
            if pair[0].max(pair[1]) > high {
                continue;
            }
            let is_behind = pair.map(|there| there < low);
            for (there, is_behind) in pair.into_iter().zip(is_behind) {
                if !is_behind {
                    low = low.min(there - step);
                    high = high.max(there + step);
                }
                sum += weight * if is_behind { behind } else { there };
            }
            weights += 2.0 * weight;
        }
        sum / weights
    })
}
