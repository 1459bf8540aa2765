//! The wall-weight function (Harada, Koshizuka & Kawaguchi 2007, "Smoothed particle hydrodynamics
//! in complex shapes"): the density that the space beyond the walls would give if it were fluid.
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
pub struct Walls {
    gauss: Gauss,
    scale: [f64; 3],
}

impl Walls {
    /// Scales the three integrals to the lattice.
    pub fn new(support_ratio: f64) -> Self {
        let gauss = Gauss::new(32);
        let s = 0.5 / support_ratio;
        let scale = [
            lattice::deficit(support_ratio, 1) / plane(&gauss, s),
            lattice::deficit(support_ratio, 2) / edge(&gauss, s, s),
            lattice::deficit(support_ratio, 3) / corner(&gauss, s, s, s),
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

    /// Derivative of [`Walls::plane`] by `s`.
    pub fn plane_slope(&self, s: f64) -> f64 {
        if s >= 1.0 {
            return 0.0;
        }
        -self.scale[0] * disc(&self.gauss, s)
    }

    /// Derivative of [`Walls::edge`] by `x`.
    pub fn edge_slope(&self, x: f64, y: f64) -> f64 {
        if x * x + y * y >= 1.0 {
            return 0.0;
        }
        -self.scale[1] * half_plane(&self.gauss, x, y)
    }

    /// Derivative of [`Walls::corner`] by `x`.
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

    /// Derivative of [`Walls::density`] by each distance, per h.
    pub fn gradient(&self, distance: DVec3) -> DVec3 {
        let by_first = |x: f64, y: f64, z: f64| {
            self.plane_slope(x) - self.edge_slope(x, y) - self.edge_slope(x, z) + self.corner_slope(x, y, z)
        };
        let [x, y, z] = distance.to_array();
        DVec3::new(by_first(x, y, z), by_first(y, z, x), by_first(z, x, y))
    }
}

/// What walls add at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WallDensity {
    /// Density ratio.
    pub density: f64,
    /// Its gradient by position (by distance, where distances are asked about), per h.
    pub gradient: DVec3,
}

/// A wall-weight function of the distances (in h) to one wall an axis, 1 or more being no wall.
pub trait WallWeight {
    /// What the walls add, with the gradient by the distances.
    fn weigh(&self, distance: DVec3) -> WallDensity;
}

impl WallWeight for Walls {
    fn weigh(&self, distance: DVec3) -> WallDensity {
        WallDensity { density: self.density(distance), gradient: self.gradient(distance) }
    }
}

/// The wall-weight function at `nodes`^3 points from distance 0 to 1, linear between them; x
/// fastest; each node is the gradient over the distances, then the density ratio.
pub struct WallTable {
    /// Points along an axis.
    pub nodes: usize,
    /// The values at the points.
    pub values: Vec<[f64; 4]>,
}

impl WallWeight for WallTable {
    fn weigh(&self, distance: DVec3) -> WallDensity {
        let place = distance.clamp(DVec3::ZERO, DVec3::ONE) * (self.nodes - 1) as f64;
        let mut sum = [0.0; 4];
        // Each of the eight nodes around counts by the product of its closeness on each axis.
        for corner in 0..8_usize {
            let mut index = 0;
            let mut share = 1.0;
            for axis in [2, 1, 0] {
                let low = (place[axis].floor() as usize).min(self.nodes - 2);
                let upper = corner >> axis & 1;
                let part = place[axis] - low as f64;
                share *= if upper == 1 { part } else { 1.0 - part };
                index = index * self.nodes + low + upper;
            }
            for (sum, value) in sum.iter_mut().zip(self.values[index]) {
                *sum += share * value;
            }
        }
        WallDensity { density: sum[3], gradient: DVec3::new(sum[0], sum[1], sum[2]) }
    }
}

/// All six walls of a box.
pub struct DomainWalls<'a> {
    /// What three walls add.
    pub weight: &'a dyn WallWeight,
    /// The box; its lowest corner is the origin.
    pub domain_size_m: DVec3,
    /// Support radius, m.
    pub support_m: f64,
}

impl DomainWalls<'_> {
    /// What the walls add at a position, with the gradient by the position.
    ///
    /// Beyond two opposite walls no point is the same, so along an axis where both are in reach the
    /// share inside is (inside the low one) + (inside the high one) - (without either).
    pub fn at(&self, position_m: DVec3) -> WallDensity {
        let mut sum = WallDensity::default();
        let low = position_m / self.support_m;
        let high = (self.domain_size_m - position_m) / self.support_m;
        let choices = [0, 1, 2].map(|axis| axis_choices(low[axis], high[axis]));
        for x in &choices[0] {
            for y in &choices[1] {
                for z in &choices[2] {
                    let distance = DVec3::new(x.distance, y.distance, z.distance);
                    let direction = DVec3::new(x.direction, y.direction, z.direction);
                    let sign = x.sign * y.sign * z.sign;
                    let weight = self.weight.weigh(distance);
                    sum.density += sign * weight.density;
                    sum.gradient += sign * direction * weight.gradient;
                }
            }
        }
        sum
    }

    /// By how much to multiply, along each axis, what neighbours do to a particle, to stand for
    /// their mirror images in the walls of the other two axes.
    ///
    /// Along a wall an even slope of pressure pulls with the integral of -y dW/dy, which by parts is
    /// that of W: the images' share of it is the density that the wall adds. Never more than doubled
    /// for an axis.
    pub fn along(&self, position_m: DVec3) -> DVec3 {
        let plane = |distance: f64| self.weight.weigh(DVec3::new(distance, 1.0, 1.0)).density;
        let gain = [0, 1, 2].map(|axis| {
            let low = position_m[axis] / self.support_m;
            let high = (self.domain_size_m[axis] - position_m[axis]) / self.support_m;
            1.0 / (1.0 - (plane(low) + plane(high)).min(0.5))
        });
        DVec3::new(gain[1] * gain[2], gain[2] * gain[0], gain[0] * gain[1])
    }
}

/// One way to count the walls of an axis.
struct AxisChoice {
    distance: f64,
    direction: f64,
    sign: f64,
}

/// The nearer wall alone, or, where both are in reach, either less none.
fn axis_choices(low: f64, high: f64) -> Vec<AxisChoice> {
    let choice = |distance, direction, sign| AxisChoice { distance, direction, sign };
    match (low < 1.0, high < 1.0) {
        (true, true) => vec![choice(low, 1.0, 1.0), choice(high, -1.0, 1.0), choice(1.0, 0.0, -1.0)],
        (true, false) => vec![choice(low, 1.0, 1.0)],
        (false, true) => vec![choice(high, -1.0, 1.0)],
        (false, false) => vec![choice(1.0, 0.0, 1.0)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::wendland::{VOLUME, gradient};

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
            let walls = Walls::new(support_ratio);
            let weight = lattice::weight(support_ratio);
            let near = 0.5 / support_ratio;
            for axes in 0..=3 {
                let mut distance = DVec3::splat(2.0);
                for axis in 0..axes {
                    distance[axis] = near;
                }
                let inside = lattice::sum_where(support_ratio, |k| k[..axes].iter().all(|&k| k >= 0));
                let ratio = weight * inside + walls.density(distance);
                assert!((ratio - 1.0).abs() < 1e-12, "{axes} walls: {ratio}");
            }
        }
    }

    #[test]
    fn follows_lattice_sums_further_in() {
        // In the second layer, one and a half spacings from the wall, only the far tail is beyond
        // it; the integral differs from the lattice's sum by the lattice's coarseness.
        let walls = Walls::new(2.0);
        let beyond = lattice::sum_where(2.0, |k| k[0] < -1) * lattice::weight(2.0);
        assert_eq!(beyond, 0.0, "at h = 2d the second layer misses nothing");
        let walls3 = Walls::new(3.0);
        let beyond = lattice::sum_where(3.0, |k| k[0] < -1) * lattice::weight(3.0);
        let difference = walls3.plane(0.5) - beyond;
        assert!(difference.abs() < 0.01, "{difference}");
        assert!(walls.plane(0.75) < 0.005, "{}", walls.plane(0.75));
    }

    #[test]
    fn gradient_is_the_derivative() {
        let walls = Walls::new(2.0);
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
        let walls = Walls::new(2.0);
        assert_eq!(walls.density(DVec3::ONE), 0.0);
        assert_eq!(walls.gradient(DVec3::ONE), DVec3::ZERO);
    }

    #[test]
    fn narrow_channels_keep_density_one() {
        // One layer between two walls, and one particle in a box of its own size.
        let walls = Walls::new(2.0);
        let weight = lattice::weight(2.0);
        for (size, layer) in [(DVec3::new(9.0, 1.0, 9.0), true), (DVec3::ONE, false)] {
            let box_walls = DomainWalls { weight: &walls, domain_size_m: size, support_m: 2.0 };
            let at = box_walls.at(size / 2.0);
            let inside = lattice::sum_where(2.0, |k| k == [0; 3] || layer && k[1] == 0);
            let ratio = weight * inside + at.density;
            assert!((ratio - 1.0).abs() < 1e-12, "{size}: {ratio}");
            assert!(at.gradient.length() < 1e-14);
        }
    }

    #[test]
    fn tables_are_exact_for_linear_functions() {
        let nodes = 5;
        let mut values = Vec::new();
        for z in 0..nodes {
            for y in 0..nodes {
                for x in 0..nodes {
                    let [x, y, z] = [x, y, z].map(|k| k as f64 / 4.0);
                    values.push([x, y, z, x + 2.0 * y + 3.0 * z]);
                }
            }
        }
        let table = WallTable { nodes, values };
        let at = DVec3::new(0.31, 0.9, 1.0);
        let got = table.weigh(at);
        assert!((got.gradient - at).length() < 1e-15);
        assert!((got.density - (0.31 + 1.8 + 3.0)).abs() < 1e-14);
        assert_eq!(table.weigh(at + 5.0).gradient, DVec3::ONE);
    }

    #[test]
    fn mirror_images_pull_along_walls() {
        // Half a spacing from a wall, in a lattice whose multiplier rises evenly along the wall: what
        // the fluid's side gives times the gain is what it and its mirror image give together.
        for (support_ratio, tolerance) in [(2.0, 0.02), (2.5, 0.02), (3.0, 0.01)] {
            let walls = Walls::new(support_ratio);
            let domain = DomainWalls { weight: &walls, domain_size_m: DVec3::splat(100.0), support_m: support_ratio };
            let pull = |walls: usize| {
                let mut sum = 0.0;
                let reach = support_ratio.ceil() as i32;
                for point in lattice::points([2 * reach as usize + 1; 3], 1.0) {
                    let offset = point - 0.5 - f64::from(reach);
                    if (0..walls).all(|axis| offset[axis] >= 0.0) {
                        sum += offset.z * gradient(-offset / support_ratio).z;
                    }
                }
                sum
            };
            for count in 0..=2 {
                let mut at = DVec3::splat(50.0);
                for axis in 0..count {
                    at[axis] = 0.5;
                }
                let error = pull(count) * domain.along(at).z / pull(0) - 1.0;
                assert!(error.abs() < tolerance, "h = {support_ratio} d, {count} walls: {error}");
            }
        }
    }
}
