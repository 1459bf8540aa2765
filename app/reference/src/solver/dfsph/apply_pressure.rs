//! What velocities take of a change of pressures.

use super::factor_pressure::PressureFactors;
use crate::boundary::mirror::Image;
use crate::params::{Smoothing, Step};
use crate::shared::wendland;
use glam::DVec3;

/// What a particle's velocity gains, m/s.
#[derive(Clone, Copy, Debug)]
pub struct Gain {
    /// All of it.
    pub gain_m_s: DVec3,
    /// What of it images in solids push.
    pub of_solids_m_s: DVec3,
    /// The sum of the lengths of what it is made of.
    pub terms_m_s: f64,
}

/// What particle `i` gains.
pub fn apply_pressure(
    i: usize,
    positions_m: &[DVec3],
    changes: &[f64],
    neighbours: &[usize],
    factors: &PressureFactors,
    step: &Step,
    smoothing: &Smoothing,
) -> Gain {
    let (mut push, mut of_solids, mut terms) = (DVec3::ZERO, DVec3::ZERO, 0.0);
    let mut add = |other: f64, seen: DVec3, image: Image| {
        let slope = wendland::gradient(seen) * smoothing.weight;
        push -= (changes[i] + other) * slope;
        of_solids -= if image.in_solids { (changes[i] + other) * slope } else { DVec3::ZERO };
        terms += (changes[i].abs() + other.abs()) * slope.length();
    };
    let mirrors = &factors.mirrors;
    mirrors.images().skip(1).for_each(|image| add(changes[i], mirrors.offset(DVec3::ZERO, image), image));
    for &j in neighbours {
        let offset = smoothing.offset(positions_m[i], positions_m[j]);
        mirrors.images().for_each(|image| add(changes[j], mirrors.offset(offset, image), image));
    }
    let speed_m_s = smoothing.support_m / step.dt_s;
    Gain { gain_m_s: push * speed_m_s, of_solids_m_s: of_solids * speed_m_s, terms_m_s: terms * speed_m_s }
}
