//! Density ratio and stiffness of a particle where it is.

use crate::boundary::mirror::Mirrors;
use crate::params::Smoothing;
use crate::shared::wendland;
use crate::solver::pbf::correct_positions::COINCIDENT;
use glam::DVec3;

/// What the iterations of both solves ask of a particle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PressureFactors {
    /// Where walls mirror the fluid.
    pub mirrors: Mirrors,
    /// Density ratio − 1.
    pub excess: f64,
    /// 1/α of the papers: |Σ ∇W|² + Σ |∇W|², a neighbour and its images being one.
    pub stiffness: f64,
    /// Whether it takes part.
    pub is_simulated: bool,
}

/// A stiffness is taken to be no less: with all its particles at one point a constraint has no gradient, and nothing to divide
/// by.
pub const STIFFNESS_FLOOR: f64 = 1e-6;
/// Pairs closer than this, in h, part.
pub const SEPARATION: f64 = 0.12;
/// How far each of two at one point moves in a substep, h.
pub const SEPARATION_SHIFT: f64 = 0.02;

/// What parts particle `i` from those too close to it, h. `drawn` gives the direction, of length 1, in which it parts from
/// another at its own place.
pub fn separation(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
    drawn: impl Fn(usize, usize) -> DVec3,
) -> DVec3 {
    let of = |&j: &usize| {
        let offset = smoothing.offset(positions_m[i], positions_m[j]);
        let q = offset.length();
        let direction = if q < COINCIDENT { drawn(i, j) } else { offset / q };
        direction * SEPARATION_SHIFT * (1.0 - q / SEPARATION).max(0.0)
    };
    neighbours.iter().map(of).sum()
}

/// Those of particle `i`.
pub fn factor_pressure(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
    mirrors: Mirrors,
    is_simulated: bool,
) -> PressureFactors {
    let slope = |seen: DVec3| wendland::gradient(seen) * smoothing.weight;
    let (mut density, mut own, mut others) = (smoothing.weight, DVec3::ZERO, 0.0);
    for image in mirrors.images().skip(1) {
        let seen = mirrors.offset(DVec3::ZERO, image);
        density += wendland::kernel(seen.length()) * smoothing.weight;
        // It comes nearer twice as fast as the particle does.
        own += 2.0 * slope(seen);
    }
    for &j in neighbours {
        let offset = smoothing.offset(positions_m[i], positions_m[j]);
        let mut pushed = DVec3::ZERO;
        for image in mirrors.images() {
            let seen = mirrors.offset(offset, image);
            density += wendland::kernel(seen.length()) * smoothing.weight;
            own += slope(seen);
            pushed += mirrors.mirrored_back(slope(seen), image);
        }
        others += pushed.length_squared();
    }
    PressureFactors {
        mirrors,
        excess: density - 1.0,
        stiffness: (own.length_squared() + others).max(STIFFNESS_FLOOR),
        is_simulated,
    }
}
