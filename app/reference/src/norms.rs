//! Error norms: of values that belong together, and of point clouds, where after an impact no
//! particle belongs to another.

use crate::shared::cells::Cells;
use glam::DVec3;

/// Norms of a difference over its samples, each a mean or extreme and so free of their number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Norms {
    /// Mean of |difference|.
    pub l1: f64,
    /// Root of the mean square.
    pub l2: f64,
    /// Largest |difference|.
    pub l_inf: f64,
}

/// Norms of `values - expected`; `None` where there is nothing to compare, or lengths differ. A NaN
/// anywhere is a NaN in every norm, so that no limit is kept by it.
pub fn norms(values: &[f64], expected: &[f64]) -> Option<Norms> {
    if values.is_empty() || values.len() != expected.len() {
        return None;
    }
    let n = values.len() as f64;
    let mut sum = Norms::default();
    for (value, expected) in values.iter().zip(expected) {
        let difference = (value - expected).abs();
        sum.l1 += difference / n;
        sum.l2 += difference * difference / n;
        // f64::max would drop a NaN.
        if difference > sum.l_inf || difference.is_nan() {
            sum.l_inf = difference;
        }
    }
    sum.l2 = sum.l2.sqrt();
    if sum.l1.is_nan() {
        sum.l_inf = f64::NAN;
    }
    Some(sum)
}

/// Distances between two clouds of points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CloudDistance {
    /// Mean distance from a point to the other cloud, averaged over both directions.
    pub chamfer: f64,
    /// The largest of them.
    pub hausdorff: f64,
}

/// Chamfer and Hausdorff distance in units of `spacing`; `None` for an empty cloud or one with
/// points that are not finite.
pub fn cloud_distance(a: &[DVec3], b: &[DVec3], spacing: f64) -> Option<CloudDistance> {
    let unfit = |points: &[DVec3]| points.is_empty() || points.iter().any(|p| !p.is_finite());
    if unfit(a) || unfit(b) {
        return None;
    }
    let one_way = |from: &[DVec3], to: &[DVec3]| {
        let cells = Cells::new(to, spacing);
        let (mut sum, mut largest) = (0.0, 0.0_f64);
        for &point in from {
            let distance = cells.nearest(point);
            sum += distance;
            largest = largest.max(distance);
        }
        (sum / from.len() as f64, largest)
    };
    let (there, back) = (one_way(a, b), one_way(b, a));
    Some(CloudDistance { chamfer: (there.0 + back.0) / 2.0 / spacing, hausdorff: there.1.max(back.1) / spacing })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::lattice;

    #[test]
    fn of_known_differences() {
        let norms = norms(&[1.0, 2.0, 3.0, 4.0], &[1.0, 2.0, 3.0, 2.0]).unwrap();
        assert_eq!((norms.l1, norms.l2, norms.l_inf), (0.5, 1.0, 2.0));
    }

    #[test]
    fn nothing_to_compare_is_no_agreement() {
        assert_eq!(norms(&[], &[]), None);
        assert_eq!(norms(&[1.0], &[1.0, 2.0]), None);
        let nan = norms(&[1.0, f64::NAN, 1.0], &[1.0; 3]).unwrap();
        assert!(nan.l1.is_nan() && nan.l2.is_nan() && nan.l_inf.is_nan());
    }

    #[test]
    fn clouds() {
        let points = lattice::points([4, 4, 4], 0.1);
        let same = cloud_distance(&points, &points, 0.1).unwrap();
        assert_eq!((same.chamfer, same.hausdorff), (0.0, 0.0));
        let mut moved = points.clone();
        moved[63] += DVec3::new(0.3, 0.0, 0.0);
        let distance = cloud_distance(&points, &moved, 0.1).unwrap();
        assert!((distance.hausdorff - 3.0).abs() < 1e-12);
        // There 3 spacings of one point; back one spacing, from where it was.
        assert!((distance.chamfer - (3.0 + 1.0) / 64.0 / 2.0).abs() < 1e-12);
        assert_eq!(cloud_distance(&points, &[], 0.1), None);
        assert_eq!(cloud_distance(&points, &[DVec3::NAN], 0.1), None);
    }
}
