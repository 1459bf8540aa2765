//! How the density of a particle changes with the velocities that are reached, and what its pressure has to change by.

use super::factor_pressure::PressureFactors;
use crate::boundary::mirror::Image;
use crate::params::{Smoothing, Step};
use crate::shared::wendland;
use glam::DVec3;

/// Weights and bounds of a solve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureSolve {
    /// Mean residual at which the iterations end.
    pub tolerance: f64,
    /// Weight of the first iteration's residual.
    pub first_step: f64,
    /// Weight of the others'.
    pub step: f64,
    /// Of what the iteration before added, of all but the first.
    pub momentum: f64,
    /// Weight of a residual where the fluid is very compressed.
    pub guarded_step: f64,
    /// Of what a particle is thinner than at rest: by so much it may grow denser.
    pub room_share: f64,
    /// Of what it is denser: so much is to go.
    pub excess_share: f64,
    /// Of the last substep's pressures, with which the solve begins; 0 where it begins cold.
    pub warm_share: f64,
    /// Iterations at most.
    pub most_iterations: usize,
    /// Before which no residual ends it.
    pub least_iterations: usize,
    /// Whether there are that many, whatever is left.
    pub is_fixed: bool,
}

/// Compression above which steps become shorter, and from which on they are plain Jacobi's over the density ratio.
pub const GUARD: [f64; 2] = [0.04, 0.08];

/// What an iteration finds at a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// Of its pressure.
    pub change: f64,
    /// What a full Jacobi step would change, as a density ratio.
    pub residual: f64,
    /// What the solve wants to be 0.
    pub error: f64,
}

/// What the density ratio of particle `i` changes by in a substep with these velocities, and the sum of the sizes of what that
/// is made of.
pub fn density_change(
    i: usize,
    positions_m: &[DVec3],
    velocities_m_s: &[DVec3],
    neighbours: &[usize],
    factors: &PressureFactors,
    step: &Step,
    smoothing: &Smoothing,
) -> (f64, f64) {
    let own = velocities_m_s[i];
    let (mut per_s, mut terms) = (0.0, 0.0);
    let mirrors = &factors.mirrors;
    let mut add = |other_m_s: DVec3, seen: DVec3, image: Image| {
        let slope = wendland::gradient(seen) * smoothing.weight;
        let apart_m_s = own - mirrors.mirrored_velocity(other_m_s, image);
        per_s += slope.dot(apart_m_s);
        terms += slope.length() * apart_m_s.length();
    };
    mirrors.images().skip(1).for_each(|image| add(own, mirrors.offset(DVec3::ZERO, image), image));
    for &j in neighbours {
        let offset = smoothing.offset(positions_m[i], positions_m[j]);
        mirrors.images().for_each(|image| add(velocities_m_s[j], mirrors.offset(offset, image), image));
    }
    let of_a_step = step.dt_s / smoothing.support_m;
    (per_s * of_a_step, terms * of_a_step)
}

/// What a pressure of `total`, which the iteration before changed by `before`, changes by; `first`: of the first iteration.
pub fn correct_pressure(
    factors: &PressureFactors,
    density_change: f64,
    total: f64,
    before: f64,
    first: bool,
    solve: &PressureSolve,
) -> Correction {
    let share = if factors.excess > 0.0 { solve.excess_share } else { solve.room_share };
    let error = share * factors.excess + density_change;
    if !factors.is_simulated {
        return Correction { change: 0.0_f64.max(total) - total, residual: 0.0, error };
    }
    let jacobi = error / factors.stiffness;
    let residual = ((total + jacobi).max(0.0) - total).abs() * factors.stiffness;
    let fast = if first { solve.first_step * jacobi } else { solve.step * jacobi + solve.momentum * before };
    let guard = ((factors.excess - GUARD[0]) / (GUARD[1] - GUARD[0])).clamp(0.0, 1.0);
    let change = fast + guard * (solve.guarded_step / (1.0 + factors.excess.max(0.0)) * jacobi - fast);
    Correction { change: (total + change).max(0.0) - total, residual, error }
}
