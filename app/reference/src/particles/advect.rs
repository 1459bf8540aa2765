//! Where a particle goes with its velocity, and what that takes of the last acceleration. (Shader:
//! `particles/advect.compute`.)

use super::predict::{Particle, Predicted};
use crate::boundary::confine_path;
use crate::params::Step;

/// Shares of dt that a velocity takes of an acceleration before the next move, after it, and when it is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Kicks {
    /// Before the move.
    pub before: f64,
    /// After it.
    pub after: f64,
    /// When it is computed.
    pub end: f64,
}

/// Moves one particle; one that had no acceleration yet falls freely.
pub fn advect(before: Particle, step: &Step, kicks: &Kicks) -> Predicted {
    if !before.is_simulated() {
        return Predicted { particle: before, slowed: false };
    }
    let kick_m_s = before.acceleration_m_s2.unwrap_or(step.gravity_m_s2) * step.dt_s;
    let kicked_m_s = before.velocity_m_s + kick_m_s * kicks.before;
    if !before.position_m.is_finite() || !kicked_m_s.is_finite() {
        let particle = before.parked();
        return Predicted { particle, slowed: false };
    }
    let (velocity_m_s, slowed) = step.slowed(kicked_m_s);
    let free_m = before.position_m + velocity_m_s * step.dt_s;
    let (position_m, velocity_m_s) = confine_path(free_m, velocity_m_s + kick_m_s * kicks.after, step);
    let particle = Particle { position_m: step.wrapped(position_m), velocity_m_s, ..before };
    Predicted { particle, slowed }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{BVec3, DVec3};

    #[test]
    fn free_fall_is_each_integrators_closed_form() {
        // After n substeps from rest: leap-frog is exact, n^2/2 g dt^2, symplectic Euler n (n + 1)/2, Euler n (n - 1)/2.
        let g = DVec3::new(0.5, -9.81, 0.25);
        let step = Step {
            gravity_m_s2: g,
            dt_s: 0.01,
            domain_size_m: DVec3::ONE,
            walls: BVec3::FALSE,
            period_m: DVec3::ZERO,
            wall_offset_m: 0.0,
            max_speed_m_s: 1e3,
        };
        for (kicks, law) in [
            (Kicks { before: 0.5, after: 0.0, end: 0.5 }, (|n: f64| 0.5 * n * n) as fn(f64) -> f64),
            (Kicks { before: 1.0, after: 0.0, end: 0.0 }, |n| 0.5 * n * (n + 1.0)),
            (Kicks { before: 0.0, after: 1.0, end: 0.0 }, |n| 0.5 * n * (n - 1.0)),
        ] {
            let mut particle = Particle::default();
            for n in 1..=50 {
                particle = advect(particle, &step, &kicks).particle;
                particle.acceleration_m_s2 = Some(g);
                particle.velocity_m_s += g * (kicks.end * step.dt_s);
                let expected = g * step.dt_s.powi(2) * law(f64::from(n));
                assert!((particle.position_m - expected).length() < 1e-13, "{kicks:?} {n}: {}", particle.position_m);
            }
        }
    }
}
