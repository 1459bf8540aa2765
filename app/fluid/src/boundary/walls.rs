//! What walls count, so that the shader's closed form of the wall-weight function (Harada, Koshizuka
//! & Kawaguchi 2007) agrees with the lattice. (Shader: `boundary/walls.hlsli`.)
//!
//! Beyond one wall at distance s lies the share P(s) of the kernel; beyond several at right angles
//! nearly the product of their shares: within .003 of the kernel's integral, .004 in two dimensions.
//! By inclusion and exclusion the density ratio beyond the walls is a ΣP − e ΣPP + c PPP. Shares stand
//! for wall particles at rest; a, e and c are such that fluid placed half a spacing from walls has
//! density ratio 1 at walls, edges and corners alike.

use std::f64::consts::PI;

use crate::smoothing_kernel::{for_lattice, lattice, wendland};

/// Coefficients c of the share of Wendland's kernel beyond a wall that it reaches by t (in h):
/// t⁵ (c₀ + c₁ t + c₂ t² + c₃ t³). In three dimensions that is the integral itself. In two it has
/// logarithms; this is within 5e-5 of it and of its slope within 1e-3 / h (least squares over 0 to h; test
/// `planes_of_two_dimensions_are_close_to_their_integrals` of the twin).
pub fn wall_kernel_fraction(dimensions: u32) -> [f64; 4] {
    match dimensions {
        2 => [0.684_768_84, 1.544_916_68, -2.630_423_74, 0.900_738_22],
        _ => [0.0, 3.5, -4.5, 1.5],
    }
}

/// The share of Wendland's kernel beyond a wall, at a distance in h.
pub fn beyond_wall(dimensions: u32, distance: f64) -> f64 {
    let t = (1.0 - distance).clamp(0.0, 1.0);
    let [c0, c1, c2, c3] = wall_kernel_fraction(dimensions);
    t.powi(5) * (c0 + t * (c1 + t * (c2 + t * c3)))
}

/// The density ratio of all space, as one, two or three walls' shares of it count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallScales {
    /// a: of one wall's share.
    pub plane: f64,
    /// e: of two walls' product.
    pub edge: f64,
    /// c: of three walls' product; of no use in two dimensions.
    pub corner: f64,
}

impl WallScales {
    /// The scales in 2 or 3 `dimensions` at a support of `support_ratio` spacings.
    pub fn new(dimensions: u32, support_ratio: f64) -> Self {
        let mut missing = [0.0; 3];
        for_lattice(dimensions, support_ratio, |step, q| {
            for (axes, sum) in missing.iter_mut().enumerate() {
                if step[..=axes].iter().all(|&k| k > 0) {
                    *sum += wendland(q);
                }
            }
        });
        let weight = lattice(dimensions, support_ratio).weight;
        let share = beyond_wall(dimensions, 0.5 / support_ratio);
        // Where the lattice has no point beyond an edge or a corner, the continuum stands in: the
        // kernel's integral is 2 pi / 21 h^3, or pi / 7 h^2.
        let integral = if dimensions == 2 { PI / 7.0 } else { 2.0 * PI / 21.0 };
        let continuum = weight * support_ratio.powi(dimensions as i32) * integral;
        let scale = |sum: f64, share: f64| if sum > 0.0 { weight * sum / share } else { continuum };
        Self {
            plane: scale(missing[0], share),
            edge: scale(missing[1], share.powi(2)),
            corner: scale(missing[2], share.powi(3)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lattice_against_walls_has_density_ratio_one() {
        for (dimensions, support_ratio) in [2, 3].into_iter().flat_map(|n| [2.0, 2.5, 3.0].map(|ratio| (n, ratio))) {
            let scales = WallScales::new(dimensions, support_ratio);
            let weight = lattice(dimensions, support_ratio).weight;
            let share = beyond_wall(dimensions, 0.5 / support_ratio);
            for walls in 0..=dimensions as usize {
                let mut inside = 0.0;
                for_lattice(dimensions, support_ratio, |step, q| {
                    if step[..walls].iter().all(|&k| k >= 0) {
                        inside += wendland(q) * weight;
                    }
                });
                // Of one, two and three walls: how many planes, edges and corners there are.
                let [planes, edges, corners] = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0]][walls];
                let beyond = scales.plane * planes * share - scales.edge * edges * share.powi(2)
                    + scales.corner * corners * share.powi(3);
                let ratio = inside + beyond;
                assert!((ratio - 1.0).abs() < 1.0e-12, "{dimensions}-D, h = {support_ratio} d, {walls} walls: {ratio}");
            }
        }
    }

    #[test]
    fn half_of_the_kernel_is_beyond_a_wall_that_is_touched() {
        for dimensions in [2, 3] {
            assert!((beyond_wall(dimensions, 0.0) - 0.5).abs() < 1.0e-12);
            assert_eq!(beyond_wall(dimensions, 1.0), 0.0);
            assert_eq!(beyond_wall(dimensions, 7.0), 0.0);
        }
    }
}
