//! What walls count, so that the shader's closed form of the wall-weight function (Harada, Koshizuka
//! & Kawaguchi 2007) agrees with the lattice. (Shader: `boundary/walls.hlsl`.)
//!
//! Beyond one wall at distance s lies the share P(s) of the kernel; beyond several at right angles
//! nearly the product of their shares. By inclusion and exclusion the density ratio beyond the walls is
//! a ΣP − e ΣPP + c PPP. Shares stand for wall particles at rest; a, e and c are such that fluid
//! placed half a spacing from walls has density ratio 1 at walls, edges and corners alike.

use std::f64::consts::PI;

use crate::kernel::{for_lattice, lattice, wendland};

/// The share of Wendland's kernel beyond a wall, at a distance in h.
pub fn beyond_wall(distance: f64) -> f64 {
    let reach = (1.0 - distance).clamp(0.0, 1.0);
    reach.powi(6) * (3.5 - 4.5 * reach + 1.5 * reach * reach)
}

/// The density ratio of all space, as one, two or three walls' shares of it count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallScales {
    /// a: of one wall's share.
    pub plane: f64,
    /// e: of two walls' product.
    pub edge: f64,
    /// c: of three walls' product.
    pub corner: f64,
}

impl WallScales {
    /// The scales at a support of `support_ratio` spacings.
    pub fn new(support_ratio: f64) -> Self {
        let mut missing = [0.0; 3];
        for_lattice(support_ratio, |step, q| {
            for (axes, sum) in missing.iter_mut().enumerate() {
                if step[..=axes].iter().all(|&k| k > 0) {
                    *sum += wendland(q);
                }
            }
        });
        let weight = lattice(support_ratio).weight;
        let share = beyond_wall(0.5 / support_ratio);
        // Where the lattice has no point beyond an edge or a corner, the continuum stands in: the
        // kernel's integral is 2 pi / 21 h^3.
        let continuum = weight * support_ratio.powi(3) * 2.0 * PI / 21.0;
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
        for support_ratio in [2.0, 2.5, 3.0] {
            let scales = WallScales::new(support_ratio);
            let weight = lattice(support_ratio).weight;
            let share = beyond_wall(0.5 / support_ratio);
            for walls in 0..=3 {
                let mut inside = 0.0;
                for_lattice(support_ratio, |step, q| {
                    if step[..walls].iter().all(|&k| k >= 0) {
                        inside += wendland(q) * weight;
                    }
                });
                // Of one, two and three walls: how many planes, edges and corners there are.
                let [planes, edges, corners] = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0]][walls];
                let beyond = scales.plane * planes * share - scales.edge * edges * share.powi(2)
                    + scales.corner * corners * share.powi(3);
                let ratio = inside + beyond;
                assert!((ratio - 1.0).abs() < 1.0e-12, "h = {support_ratio} d, {walls} walls: {ratio}");
            }
        }
    }

    #[test]
    fn half_of_the_kernel_is_beyond_a_wall_that_is_touched() {
        assert_eq!(beyond_wall(0.0), 0.5);
        assert_eq!(beyond_wall(1.0), 0.0);
        assert_eq!(beyond_wall(7.0), 0.0);
    }
}
