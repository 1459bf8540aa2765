//! Compression of a cloud of particles by a yardstick that belongs to no solver: density by a cubic
//! spline of support 2 d over the fluid mirrored in the domain's six walls, relative to its value
//! on the lattice of spacing d; max(ratio - 1, 0) of each particle.

use crate::shared::cells::Cells;
use glam::DVec3;

/// Of some particles, as ratios (0.02 is 2 %).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Summary {
    /// How many they are.
    pub particles: usize,
    /// Mean; zero if there are none.
    pub mean: f64,
    /// What one particle in a hundred exceeds.
    pub p99: f64,
    /// The worst particle.
    pub max: f64,
}

/// What is reported of a snapshot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Compression {
    /// All particles.
    pub all: Summary,
    /// Those nearer than 2 d to a wall, which the metric's mirror reaches.
    pub wall: Summary,
    /// The others.
    pub inner: Summary,
}

impl Summary {
    fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let particles = values.len();
        let Some(&max) = values.last() else {
            return Self::default();
        };
        Self {
            particles,
            mean: values.iter().sum::<f64>() / particles as f64,
            p99: values[particles - 1 - particles / 100],
            max,
        }
    }
}

/// The cubic spline (Monaghan 1992) of q = r / support, scaled to W(0) = 1.
fn cubic_spline(q: f64) -> f64 {
    if q < 0.5 {
        1.0 - 6.0 * q * q * (1.0 - q)
    } else if q < 1.0 {
        2.0 * (1.0 - q).powi(3)
    } else {
        0.0
    }
}

/// Compression of particles in the box from `min_m` to `max_m`; `None` without particles, or with
/// one that is not finite.
pub fn compression(positions_m: &[DVec3], min_m: DVec3, max_m: DVec3, spacing_m: f64) -> Option<Compression> {
    if positions_m.is_empty() || positions_m.iter().any(|p| !p.is_finite()) {
        return None;
    }
    let support_m = 2.0 * spacing_m;
    // 1 + 6 at d + 12 at sqrt 2 d + 8 at sqrt 3 d; what is 2 d away is on the support's edge.
    let lattice = 1.0
        + 6.0 * cubic_spline(0.5)
        + 12.0 * cubic_spline(0.5 * 2.0_f64.sqrt())
        + 8.0 * cubic_spline(0.5 * 3.0_f64.sqrt());

    let mirrored = mirror(positions_m, min_m, max_m, support_m);
    let cells = Cells::new(&mirrored, support_m);
    let compressions: Vec<f64> = positions_m
        .iter()
        .map(|&at| {
            let sum: f64 =
                cells.near(at, support_m).map(|j| cubic_spline((mirrored[j] - at).length() / support_m)).sum();
            (sum / lattice - 1.0).max(0.0)
        })
        .collect();

    let inside = |p: DVec3| (p - min_m).min(max_m - p).min_element() >= support_m;
    let of = |wanted: &dyn Fn(DVec3) -> bool| {
        let chosen = compressions.iter().zip(positions_m).filter(|(_, p)| wanted(**p));
        Summary::of(chosen.map(|(compression, _)| *compression).collect())
    };
    Some(Compression { all: of(&|_| true), wall: of(&|p| !inside(p)), inner: of(&inside) })
}

/// The particles and their images in the walls, edges and corners within `reach_m`.
fn mirror(positions_m: &[DVec3], min_m: DVec3, max_m: DVec3, reach_m: f64) -> Vec<DVec3> {
    let mut all = positions_m.to_vec();
    for axis in 0..3 {
        for i in 0..all.len() {
            let at = all[i];
            for wall in [min_m[axis], max_m[axis]] {
                if (at[axis] - wall).abs() < reach_m {
                    let mut image = at;
                    image[axis] = 2.0 * wall - at[axis];
                    all.push(image);
                }
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::lattice;

    #[test]
    fn a_full_box_is_not_compressed() {
        let points = lattice::points([8, 6, 5], 0.1);
        let size = DVec3::new(0.8, 0.6, 0.5);
        let full = compression(&points, DVec3::ZERO, size, 0.1).unwrap();
        assert!(full.all.max < 1e-12, "{full:?}");
    }

    #[test]
    fn a_squeezed_fluid_is() {
        // 5 % closer along x: the density along x is right again from the middle of the block.
        let points: Vec<DVec3> =
            lattice::points([12, 8, 8], 0.1).iter().map(|p| *p * DVec3::new(0.95, 1.0, 1.0)).collect();
        let size = DVec3::new(0.95 * 1.2, 0.8, 0.8);
        let squeezed = compression(&points, DVec3::ZERO, size, 0.1).unwrap();
        assert!(squeezed.all.mean > 0.03 && squeezed.all.mean < 0.08, "{squeezed:?}");
        assert!((squeezed.inner.mean - squeezed.wall.mean).abs() < 1e-9, "mirrored walls are even");
    }

    #[test]
    fn a_pile_at_a_wall_is_seen_as_the_worst() {
        let mut points = lattice::points([8, 8, 8], 0.1);
        points.push(points[0] + DVec3::splat(0.001));
        let piled = compression(&points, DVec3::ZERO, DVec3::splat(0.8), 0.1).unwrap();
        assert!(piled.all.max > 0.5 && piled.inner.max < 1e-12, "{piled:?}");
        assert_eq!(piled.wall.max, piled.all.max);
        assert_eq!((piled.inner.particles, piled.wall.particles), (64, 449));
        assert_eq!(compression(&[], DVec3::ZERO, DVec3::ONE, 0.1), None);
        assert_eq!(compression(&[DVec3::NAN], DVec3::ZERO, DVec3::ONE, 0.1), None);
    }
}
