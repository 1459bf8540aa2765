//! Curl of the velocity field (Macklin & Muller 2013, eq. 15).

use crate::params::Smoothing;
use crate::shared::wendland;
use glam::DVec3;

/// The curl at particle `i`, 1/s: sum of (v_j - v_i) x grad_j W, with the particle's volume.
pub fn curl(
    i: usize,
    positions_m: &[DVec3],
    velocities_m_s: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
) -> DVec3 {
    neighbours
        .iter()
        .map(|&j| {
            let offset = smoothing.offset(positions_m[j], positions_m[i]);
            let gradient = wendland::gradient(offset) * (smoothing.weight / smoothing.support_m);
            (velocities_m_s[j] - velocities_m_s[i]).cross(gradient)
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::list_neighbours::list_neighbours;
    use crate::shared::lattice;

    #[test]
    fn of_a_rigid_rotation_is_twice_its_rate() {
        // The lattice's second moment of the gradient differs from the integral's by its
        // coarseness: 3 d is close enough for 5 %, and the direction is exact by symmetry.
        let points = lattice::points([7, 7, 7], 1.0);
        let omega = DVec3::new(0.3, -0.2, 0.5);
        let velocities: Vec<DVec3> = points.iter().map(|p| omega.cross(*p)).collect();
        let smoothing = Smoothing::new(3.0, lattice::weight(3, 3.0));
        let lists = list_neighbours(&points, |_| false, 3.0);
        let curl = curl(171, &points, &velocities, &lists[171], &smoothing);
        assert!(curl.cross(omega).length() < 1e-12);
        assert!((curl.length() / (2.0 * omega.length()) - 1.0).abs() < 0.05, "{curl}");
    }
}
