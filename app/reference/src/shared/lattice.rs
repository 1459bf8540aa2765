//! Sums of the kernel over the lattice that a fluid starts on (cubic, or square in two dimensions): what
//! density ratio 1 means.

use super::wendland::kernel;
use glam::DVec3;

/// 1 / sum of W over the infinite lattice of 2 or 3 `dimensions`, where `support_ratio` = h / spacing. A
/// particle of that lattice then has density ratio 1.
pub fn weight(dimensions: u32, support_ratio: f64) -> f64 {
    1.0 / sum_where(dimensions, support_ratio, |_| true)
}

/// Sum of W around a lattice point over the points whose integer offset is `wanted`.
pub fn sum_where(dimensions: u32, support_ratio: f64, wanted: impl Fn([i32; 3]) -> bool) -> f64 {
    sum(dimensions, support_ratio, |offset, q| if wanted(offset) { kernel(q) } else { 0.0 })
}

/// Sum over the points around a lattice point, itself among them, as far as the support reaches along each axis: of their
/// integer offset and their distance in h.
pub fn sum(dimensions: u32, support_ratio: f64, of: impl Fn([i32; 3], f64) -> f64) -> f64 {
    let reach = support_ratio.ceil() as i32;
    let deep = if dimensions == 2 { 0 } else { reach };
    let mut sum = 0.0;
    for x in -reach..=reach {
        for y in -reach..=reach {
            for z in -deep..=deep {
                let r = DVec3::new(f64::from(x), f64::from(y), f64::from(z)).length();
                sum += of([x, y, z], r / support_ratio);
            }
        }
    }
    sum
}

/// The share of the lattice's density that lies beyond one wall (`axes` = 1), beyond two at once
/// (an edge) or three (a corner), for a particle half a spacing from each.
pub fn deficit(dimensions: u32, support_ratio: f64, axes: usize) -> f64 {
    let sum = sum_where(dimensions, support_ratio, |offset| offset[..axes].iter().all(|&k| k < 0));
    weight(dimensions, support_ratio) * sum
}

/// Points of a cubic lattice of `counts` points, `spacing` apart, the first half a spacing from the
/// origin on every axis; x fastest.
pub fn points(counts: [usize; 3], spacing: f64) -> Vec<DVec3> {
    let at = |k: usize| (k as f64 + 0.5) * spacing;
    let mut points = Vec::with_capacity(counts.iter().product());
    for z in 0..counts[2] {
        for y in 0..counts[1] {
            for x in 0..counts[0] {
                points.push(DVec3::new(at(x), at(y), at(z)));
            }
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::wendland::VOLUME;
    use std::f64::consts::PI;

    #[test]
    fn approaches_the_integral() {
        // With many neighbours the lattice sum is the integral over the spacing's volume.
        for (dimensions, integral) in [(2, PI / 7.0), (3, VOLUME)] {
            let sum = 1.0 / weight(dimensions, 8.0);
            let integral = integral * 8.0_f64.powi(dimensions as i32);
            assert!((sum / integral - 1.0).abs() < 1e-3, "{dimensions}-D: {}", sum / integral);
        }
    }

    #[test]
    fn deficits_shrink_with_axes() {
        let (plane, edge, corner) = (deficit(3, 2.0, 1), deficit(3, 2.0, 2), deficit(3, 2.0, 3));
        assert!(plane > edge && edge > corner && corner > 0.0);
        // The whole is eight corners, three planes of symmetry counted once: inclusion and exclusion.
        let inside = sum_where(3, 2.0, |k| k.iter().all(|&k| k >= 0)) * weight(3, 2.0);
        assert!((inside - (1.0 - 3.0 * plane + 3.0 * edge - corner)).abs() < 1e-14);
    }
}
