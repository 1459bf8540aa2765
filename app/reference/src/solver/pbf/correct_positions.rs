//! One under-relaxed Jacobi correction (Macklin & Muller 2013, eq. 12-14).

use crate::boundary::walls::DomainWalls;
use crate::boundary::{confine_position, sample_boundary};
use crate::params::{Pbf, Smoothing, Step};
use crate::shared::wendland;
use glam::DVec3;

/// A corrected position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrected {
    /// Where the particle is after the iteration.
    pub position_m: DVec3,
    /// Whether its correction was shortened.
    pub clamped: bool,
    /// Sum of the lengths of the correction's terms: what rounding is relative to.
    pub terms_m: f64,
    /// How long the correction was before it was shortened.
    pub asked_m: f64,
    /// Whether the substep's whole displacement was shortened.
    pub held: bool,
    /// How long it was before, in h.
    pub displacement: f64,
}

/// Iterations move no particle further than this from where it was predicted, in h.
pub const MAX_DISPLACEMENT: f64 = 0.999;

/// Corrects particle `i`, which was predicted at `predicted_m`. `separation` gives two particles at one point, which have no gradient,
/// a short offset (in h) from the second to the first; zero leaves them together.
#[allow(clippy::too_many_arguments)]
pub fn correct_positions(
    i: usize,
    positions_m: &[DVec3],
    predicted_m: DVec3,
    lambdas: &[f64],
    neighbours: &[usize],
    step: &Step,
    smoothing: &Smoothing,
    pbf: &Pbf,
    walls: Option<&DomainWalls>,
    separation: impl Fn(usize, usize) -> DVec3,
) -> Corrected {
    let x_i_m = positions_m[i];
    let mut correction = DVec3::ZERO;
    let mut terms = 0.0;
    for &j in neighbours {
        let mut offset = smoothing.offset(x_i_m, positions_m[j]);
        let mut q = offset.length();
        if q < COINCIDENT {
            offset = separation(i, j);
            q = offset.length();
        }
        let mut pair_lambda = lambdas[i] + lambdas[j];
        if pbf.s_corr_k != 0.0 {
            // eq. 13: a repulsion that is k where W is that of the chosen distance.
            pair_lambda -= pbf.s_corr_k * (wendland::kernel(q) * pbf.s_corr_inverse_w).powi(4);
        }
        if q < pbf.separation {
            pair_lambda += pbf.separation_lambda * (1.0 - q / pbf.separation);
        }
        if q > 0.0 {
            let slope = wendland::slope(q) * smoothing.weight * pair_lambda;
            correction += offset * (slope / q);
            terms += slope.abs();
        }
    }
    let boundary = sample_boundary(x_i_m, walls);
    // A boundary answers with the particle's own lambda, as the fluid mirrored in a wall would.
    let push = boundary.gradient * (lambdas[i] + lambdas[i]);
    correction = correction * boundary.correction_scale + push;
    terms = terms * boundary.correction_scale.max_element() + push.length();
    let correction_m = correction * (pbf.relaxation * smoothing.support_m);
    let asked_m = correction_m.length();
    let displacement_m = x_i_m + correction_m.clamp_length_max(pbf.max_correction_m) - predicted_m;
    let displacement = displacement_m.length() / smoothing.support_m;
    let held_m = displacement_m.clamp_length_max(MAX_DISPLACEMENT * smoothing.support_m);
    Corrected {
        position_m: confine_position(predicted_m + held_m, step),
        clamped: asked_m > pbf.max_correction_m,
        held: displacement > MAX_DISPLACEMENT,
        displacement,
        terms_m: terms * pbf.relaxation * smoothing.support_m,
        asked_m,
    }
}

/// Closer than this, in h, counts as one point.
pub const COINCIDENT: f64 = 1e-4;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::list_neighbours::list_neighbours;
    use crate::shared::lattice;
    use crate::solver::pbf::constrain_density::constrain_density;
    use glam::BVec3;

    #[test]
    fn keeps_momentum_and_lowers_the_density() {
        let points: Vec<DVec3> = lattice::points([6, 5, 4], 0.8)
            .iter()
            .enumerate()
            .map(|(i, p)| *p + 0.1 * (DVec3::new(i as f64, 2.0 * i as f64, 3.0 * i as f64)).map(f64::sin))
            .collect();
        let smoothing = Smoothing::new(2.0, lattice::weight(3, 2.0));
        let pbf = Pbf {
            relaxation: 0.5,
            cfm: 1e-4,
            s_corr_k: 1e-3,
            s_corr_inverse_w: 2.0,
            max_correction_m: 1.0,
            separation: 0.0,
            separation_lambda: 0.0,
            warm_start: 0.0,
        };
        let step = Step {
            gravity_m_s2: DVec3::ZERO,
            dt_s: 0.01,
            domain_size_m: DVec3::splat(10.0),
            walls: BVec3::FALSE,
            period_m: DVec3::ZERO,
            wall_offset_m: 0.0,
            max_speed_m_s: 100.0,
        };
        let lists = list_neighbours(&points, |_| false, 2.0);
        let solve = |points: &[DVec3]| -> Vec<_> {
            (0..points.len()).map(|i| constrain_density(i, points, &lists[i], &smoothing, &pbf, None)).collect()
        };
        let before = solve(&points);
        let lambdas: Vec<f64> = before.iter().map(|m| m.lambda).collect();
        let corrected: Vec<DVec3> = (0..points.len())
            .map(|i| {
                let none = |_, _| DVec3::ZERO;
                let list = &lists[i];
                correct_positions(i, &points, points[i], &lambdas, list, &step, &smoothing, &pbf, None, none).position_m
            })
            .collect();
        let moved: DVec3 = corrected.iter().zip(&points).map(|(a, b)| *a - *b).sum();
        assert!(moved.length() < 1e-12, "equal masses: {moved}");
        let worst = |m: &[super::super::constrain_density::DensityConstraint]| {
            m.iter().map(|m| m.constraint).fold(0.0, f64::max)
        };
        assert!(worst(&solve(&corrected)) < worst(&before));
    }
}
