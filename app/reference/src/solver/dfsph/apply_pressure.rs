//! What velocities take of a change of pressures.

use super::factor_pressure::PressureFactors;
use crate::params::{Smoothing, Step};
use crate::shared::wendland;
use glam::DVec3;

/// What particle `i` gains, m/s, and the sum of the lengths of what that is made of.
pub fn apply_pressure(
    i: usize,
    positions_m: &[DVec3],
    changes: &[f64],
    neighbours: &[usize],
    factors: &PressureFactors,
    step: &Step,
    smoothing: &Smoothing,
) -> (DVec3, f64) {
    let (mut push, mut terms) = (DVec3::ZERO, 0.0);
    let mut add = |other: f64, seen: DVec3| {
        let slope = wendland::gradient(seen) * smoothing.weight;
        push -= (changes[i] + other) * slope;
        terms += (changes[i].abs() + other.abs()) * slope.length();
    };
    let mirrors = &factors.mirrors;
    mirrors.images().skip(1).for_each(|image| add(changes[i], mirrors.offset(DVec3::ZERO, image)));
    for &j in neighbours {
        let offset = smoothing.offset(positions_m[i], positions_m[j]);
        mirrors.images().for_each(|image| add(changes[j], mirrors.offset(offset, image)));
    }
    let speed_m_s = smoothing.support_m / step.dt_s;
    (push * speed_m_s, terms * speed_m_s)
}
