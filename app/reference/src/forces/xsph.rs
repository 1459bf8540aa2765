//! XSPH viscosity (Schechter & Bridson 2012; Macklin & Muller 2013, eq. 17).

use crate::params::{Forces, Smoothing};
use crate::shared::wendland;
use glam::DVec3;

/// The velocity of particle `i`, moved towards its neighbours' mean.
pub fn xsph(
    i: usize,
    positions_m: &[DVec3],
    velocities_m_s: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
    forces: &Forces,
) -> DVec3 {
    let pull: DVec3 = neighbours
        .iter()
        .map(|&j| {
            let q = smoothing.offset(positions_m[i], positions_m[j]).length();
            (velocities_m_s[j] - velocities_m_s[i]) * (smoothing.weight * wendland::kernel(q))
        })
        .sum();
    velocities_m_s[i] + pull * forces.xsph
}
