//! What acts on velocities alone, whichever solver made them.

pub mod apply_fields;
pub mod confine_vorticity;
pub mod curl;
pub mod xsph;

use crate::params::{Forces, Smoothing, Step};
use confine_vorticity::confine_vorticity;
use curl::curl;
use glam::DVec3;
use xsph::xsph;

/// The velocities after every force that there is, in the order of the GPU's.
pub fn apply(
    positions_m: &[DVec3],
    mut velocities_m_s: Vec<DVec3>,
    neighbours: &[Vec<usize>],
    step: &Step,
    smoothing: &Smoothing,
    forces: &Forces,
) -> Vec<DVec3> {
    let count = positions_m.len();
    if forces.vorticity_m_s != 0.0 {
        let curls: Vec<DVec3> =
            (0..count).map(|i| curl(i, positions_m, &velocities_m_s, &neighbours[i], smoothing)).collect();
        let confined = |i: usize| {
            let (velocity_m_s, list) = (velocities_m_s[i], &neighbours[i]);
            confine_vorticity(i, positions_m, velocity_m_s, &curls, list, step, smoothing, forces).velocity_m_s
        };
        velocities_m_s = (0..count).map(confined).collect();
    }
    if forces.xsph != 0.0 {
        velocities_m_s =
            (0..count).map(|i| xsph(i, positions_m, &velocities_m_s, &neighbours[i], smoothing, forces)).collect();
    }
    velocities_m_s
}
