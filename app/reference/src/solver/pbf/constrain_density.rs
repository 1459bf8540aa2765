//! Lambda of the density constraint (Macklin & Muller 2013, eq. 1, 8-11), unilateral: only
//! compression is a violation.

use crate::boundary::sample_boundary;
use crate::boundary::walls::DomainWalls;
use crate::measure::density::density_ratio;
use crate::params::{Pbf, Smoothing};
use crate::shared::wendland;
use glam::DVec3;

/// lambda = -constraint / (gradients + cfm), and what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DensityConstraint {
    /// Times h^2, without unit; never positive.
    pub lambda: f64,
    /// max(rho / rho0 - 1, 0).
    pub constraint: f64,
    /// rho / rho0 - 1.
    pub excess: f64,
    /// Sum of the squared gradients over all particles, plus cfm.
    pub denominator: f64,
}

/// Lambda of particle `i`.
pub fn constrain_density(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
    pbf: &Pbf,
    walls: Option<&DomainWalls>,
) -> DensityConstraint {
    let ratio = density_ratio(i, positions_m, neighbours, smoothing, walls);
    let excess = ratio - 1.0;
    let constraint = excess.max(0.0);
    // Moving a neighbour changes C by the negative of what moving i past it does.
    let mut own = sample_boundary(positions_m[i], walls).gradient;
    let mut denominator = pbf.cfm;
    for &j in neighbours {
        let offset = smoothing.offset(positions_m[i], positions_m[j]);
        let gradient = wendland::gradient(offset) * smoothing.weight;
        own += gradient;
        denominator += gradient.length_squared();
    }
    denominator += own.length_squared();
    let lambda = if constraint > 0.0 { -constraint / denominator } else { 0.0 };
    DensityConstraint { lambda, constraint, excess, denominator }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::list_neighbours::list_neighbours;
    use crate::shared::lattice;

    const PBF: Pbf = Pbf {
        relaxation: 0.5,
        cfm: 1e-4,
        s_corr_k: 0.0,
        s_corr_inverse_w: 0.0,
        max_correction_m: 1.0,
        separation: 0.0,
        separation_lambda: 0.0,
        warm_start: 0.0,
    };

    #[test]
    fn lattice_is_at_rest_and_compression_pushes() {
        let points = lattice::points([5, 5, 5], 1.0);
        let smoothing = Smoothing::new(2.0, lattice::weight(3, 2.0));
        let lists = list_neighbours(&points, |_| false, 2.0);
        let ratio = density_ratio(62, &points, &lists[62], &smoothing, None);
        assert!((ratio - 1.0).abs() < 1e-14, "{ratio}");
        let rest = constrain_density(0, &points, &lists[0], &smoothing, &PBF, None);
        assert_eq!(rest.lambda, 0.0, "a free corner does not pull");

        let squeezed: Vec<DVec3> = points.iter().map(|p| *p * 0.9).collect();
        let lists = list_neighbours(&squeezed, |_| false, 2.0);
        let pushed = constrain_density(62, &squeezed, &lists[62], &smoothing, &PBF, None);
        assert!(pushed.constraint > 0.3 && pushed.lambda < 0.0);
    }

    #[test]
    fn denominator_is_the_sum_of_numeric_gradients() {
        let points = [
            DVec3::new(0.1, 0.2, 0.3),
            DVec3::new(0.5, -0.1, 0.2),
            DVec3::new(-0.3, 0.3, 0.1),
            DVec3::new(0.2, 0.4, -0.2),
        ];
        let smoothing = Smoothing::new(2.0, 0.3);
        let neighbours = [1, 2, 3];
        let got = constrain_density(0, &points, &neighbours, &smoothing, &PBF, None);
        let mut sum = PBF.cfm;
        for k in 0..points.len() {
            for axis in 0..3 {
                let ratio = |e: f64| {
                    let mut moved = points;
                    moved[k][axis] += e;
                    density_ratio(0, &moved, &neighbours, &smoothing, None)
                };
                let slope = (ratio(1e-5) - ratio(-1e-5)) / 2e-5 * smoothing.support_m;
                sum += slope * slope;
            }
        }
        assert!((got.denominator / sum - 1.0).abs() < 1e-8);
    }
}
