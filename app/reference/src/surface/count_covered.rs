//! How many pixels show the fluid.

use super::InverseDepth;
use brooklet_kernels::COVERED_STRIDE;

/// Those that show it of one pixel in `COVERED_STRIDE` x `COVERED_STRIDE`, the first of each. (Shader:
/// `surface/count_covered.compute`.)
pub fn count_covered(from: &InverseDepth) -> u32 {
    let [width, height] = from.size_px;
    let every = |side: usize| (0..side).step_by(COVERED_STRIDE as usize);
    every(height)
        .flat_map(|y| every(width).map(move |x| [x, y]))
        .filter(|[x, y]| from.values[y * width + x] > 0.0)
        .count() as u32
}
