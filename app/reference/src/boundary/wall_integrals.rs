//! The wall-weight function (Harada, Koshizuka & Kawaguchi 2007, "Smoothed particle hydrodynamics
//! in complex shapes"), integrated: the density that the space beyond the walls would give if it were
//! fluid. What the shader computes ([`crate::boundary::walls`]) is a closed form that is close to it.
//!
//! A point at distances (x, y, z) from three walls at right angles misses the union of three
//! half-spaces. By inclusion and exclusion that is the sum of the planes, less the edges (where two
//! overlap), plus the corner (where all do). Each of the three is an integral of the kernel, scaled
//! so that half a spacing from the walls it is what the lattice itself misses: a lattice that starts
//! half a spacing from the walls then has density ratio 1 at planes, edges and corners alike.
//!
//! Integrals are by Gauss-Legendre quadrature over the ball's exact limits. Distances are in h.

use crate::shared::lattice;
use crate::shared::quadrature::Gauss;
use crate::shared::wendland::kernel;
use glam::DVec3;
use std::f64::consts::PI;

/// Integral of W over the part of space beyond one wall at `s`, in units of h^3.
pub fn plane(gauss: &Gauss, s: f64) -> f64 {
    // A slice at distance x has the area integral 2 pi rho W(sqrt(x^2 + rho^2)); with
    // r dr = rho drho it is one of r alone.
    gauss.integrate(s, 1.0, |x| disc(gauss, x))
}

/// Integral of W over the plane at distance `x`, in units of h^2.
fn disc(gauss: &Gauss, x: f64) -> f64 {
    2.0 * PI * gauss.integrate(x, 1.0, |r| r * kernel(r))
}

/// Integral of W beyond two walls at right angles, at `x` and `y`.
pub fn edge(gauss: &Gauss, x: f64, y: f64) -> f64 {
    gauss.integrate(x, chord(&[y]), |x| half_plane(gauss, x, y))
}

/// Integral of W over the part beyond `y` of the plane at `x`.
fn half_plane(gauss: &Gauss, x: f64, y: f64) -> f64 {
    gauss.integrate(y, chord(&[x]), |y| line(gauss, x, y))
}

/// Integral of W along the line at (x, y).
fn line(gauss: &Gauss, x: f64, y: f64) -> f64 {
    2.0 * ray(gauss, x, y, 0.0)
}

/// Integral of W along the part beyond `z` of the line at (x, y).
fn ray(gauss: &Gauss, x: f64, y: f64, z: f64) -> f64 {
    gauss.integrate(z, chord(&[x, y]), |z| kernel((x * x + y * y + z * z).sqrt()))
}

/// Integral of W beyond three walls, at `x`, `y` and `z`.
pub fn corner(gauss: &Gauss, x: f64, y: f64, z: f64) -> f64 {
    gauss.integrate(x, chord(&[y, z]), |x| quarter_plane(gauss, x, y, z))
}

/// Integral of W over the part beyond `y` and `z` of the plane at `x`.
fn quarter_plane(gauss: &Gauss, x: f64, y: f64, z: f64) -> f64 {
    gauss.integrate(y, chord(&[x, z]), |y| ray(gauss, x, y, z))
}

/// Where the unit ball ends along one axis, given the other coordinates.
fn chord(others: &[f64]) -> f64 {
    (1.0 - others.iter().map(|o| o * o).sum::<f64>()).max(0.0).sqrt()
}

/// The wall-weight function for one support ratio h / spacing.
pub struct WallIntegrals {
    gauss: Gauss,
    scale: [f64; 3],
}

impl WallIntegrals {
    /// Scales the three integrals to the lattice.
    pub fn new(support_ratio: f64) -> Self {
        let gauss = Gauss::new(32);
        let s = 0.5 / support_ratio;
        let scale = [
            lattice::deficit(3, support_ratio, 1) / plane(&gauss, s),
            lattice::deficit(3, support_ratio, 2) / edge(&gauss, s, s),
            lattice::deficit(3, support_ratio, 3) / corner(&gauss, s, s, s),
        ];
        Self { gauss, scale }
    }

    /// Density ratio that one wall adds at distance `s`.
    pub fn plane(&self, s: f64) -> f64 {
        self.scale[0] * plane(&self.gauss, s)
    }

    /// What two walls both add, and is counted twice by their planes.
    pub fn edge(&self, x: f64, y: f64) -> f64 {
        self.scale[1] * edge(&self.gauss, x, y)
    }

    /// What three walls all add.
    pub fn corner(&self, x: f64, y: f64, z: f64) -> f64 {
        self.scale[2] * corner(&self.gauss, x, y, z)
    }

    /// Derivative of [`WallIntegrals::plane`] by `s`.
    pub fn plane_slope(&self, s: f64) -> f64 {
        if s >= 1.0 {
            return 0.0;
        }
        -self.scale[0] * disc(&self.gauss, s)
    }

    /// Derivative of [`WallIntegrals::edge`] by `x`.
    pub fn edge_slope(&self, x: f64, y: f64) -> f64 {
        if x * x + y * y >= 1.0 {
            return 0.0;
        }
        -self.scale[1] * half_plane(&self.gauss, x, y)
    }

    /// Derivative of [`WallIntegrals::corner`] by `x`.
    pub fn corner_slope(&self, x: f64, y: f64, z: f64) -> f64 {
        if x * x + y * y + z * z >= 1.0 {
            return 0.0;
        }
        -self.scale[2] * quarter_plane(&self.gauss, x, y, z)
    }

    /// Density ratio that three walls at `distance` add together.
    pub fn density(&self, distance: DVec3) -> f64 {
        let [x, y, z] = distance.to_array();
        let planes = self.plane(x) + self.plane(y) + self.plane(z);
        let edges = self.edge(x, y) + self.edge(y, z) + self.edge(z, x);
        planes - edges + self.corner(x, y, z)
    }

    /// Derivative of [`WallIntegrals::density`] by each distance, per h.
    pub fn gradient(&self, distance: DVec3) -> DVec3 {
        let by_first = |x: f64, y: f64, z: f64| {
            self.plane_slope(x) - self.edge_slope(x, y) - self.edge_slope(x, z) + self.corner_slope(x, y, z)
        };
        let [x, y, z] = distance.to_array();
        DVec3::new(by_first(x, y, z), by_first(y, z, x), by_first(z, x, y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::wendland::VOLUME;

    #[test]
    fn halves_quarters_and_eighths() {
        // 32 points leave the kernel's kink at r = h, where its fourth derivative jumps, and its
        // cone at r = 0 in the last digits.
        let gauss = Gauss::new(32);
        for (name, integral, share) in [
            ("plane", plane(&gauss, 0.0), 2.0),
            ("edge", edge(&gauss, 0.0, 0.0), 4.0),
            ("corner", corner(&gauss, 0.0, 0.0, 0.0), 8.0),
        ] {
            let error = integral * share / VOLUME - 1.0;
            assert!(error.abs() < 1e-7, "{name}: {error}");
        }
    }

    #[test]
    fn plane_has_its_closed_form() {
        // Integrating r W(r) by hand: with t = 1 - r, r W = (1 - t) t^4 (5 - 4 t), twice.
        let gauss = Gauss::new(32);
        let closed = |s: f64| {
            let t = 1.0 - s;
            2.0 * PI * (t.powi(6) / 6.0 - 9.0 * t.powi(7) / 42.0 + 4.0 * t.powi(8) / 56.0)
        };
        for i in 0..=10 {
            let s = f64::from(i) / 10.0;
            assert!((plane(&gauss, s) - closed(s)).abs() < 1e-14, "s = {s}");
        }
    }

    #[test]
    fn lattice_keeps_density_one() {
        for support_ratio in [2.0, 2.5, 3.0] {
            let walls = WallIntegrals::new(support_ratio);
            let weight = lattice::weight(3, support_ratio);
            let near = 0.5 / support_ratio;
            for axes in 0..=3 {
                let mut distance = DVec3::splat(2.0);
                for axis in 0..axes {
                    distance[axis] = near;
                }
                let inside = lattice::sum_where(3, support_ratio, |k| k[..axes].iter().all(|&k| k >= 0));
                let ratio = weight * inside + walls.density(distance);
                assert!((ratio - 1.0).abs() < 1e-12, "{axes} walls: {ratio}");
            }
        }
    }

    #[test]
    fn follows_lattice_sums_further_in() {
        // In the second layer, one and a half spacings from the wall, only the far tail is beyond
        // it; the integral differs from the lattice's sum by the lattice's coarseness.
        let walls = WallIntegrals::new(2.0);
        let beyond = lattice::sum_where(3, 2.0, |k| k[0] < -1) * lattice::weight(3, 2.0);
        assert_eq!(beyond, 0.0, "at h = 2d the second layer misses nothing");
        let walls3 = WallIntegrals::new(3.0);
        let beyond = lattice::sum_where(3, 3.0, |k| k[0] < -1) * lattice::weight(3, 3.0);
        let difference = walls3.plane(0.5) - beyond;
        assert!(difference.abs() < 0.01, "{difference}");
        assert!(walls.plane(0.75) < 0.005, "{}", walls.plane(0.75));
    }

    #[test]
    fn gradient_is_the_derivative() {
        let walls = WallIntegrals::new(2.0);
        for at in [DVec3::new(0.25, 0.3, 0.1), DVec3::new(0.1, 0.8, 2.0), DVec3::new(0.5, 2.0, 2.0)] {
            let gradient = walls.gradient(at);
            for axis in 0..3 {
                let mut e = DVec3::ZERO;
                e[axis] = 1e-5;
                let difference = (walls.density(at + e) - walls.density(at - e)) / 2e-5;
                assert!((gradient[axis] - difference).abs() < 1e-6, "{at} axis {axis}");
            }
        }
    }

    #[test]
    fn vanishes_beyond_the_support() {
        let walls = WallIntegrals::new(2.0);
        assert_eq!(walls.density(DVec3::ONE), 0.0);
        assert_eq!(walls.gradient(DVec3::ONE), DVec3::ZERO);
    }
}
