//! Where each particle would go without its neighbours (Macklin & Muller 2013, algorithm 1, lines
//! 1-4): symplectic Euler, then the walls, whose contact is inelastic.

use crate::boundary::confine_path;
use crate::params::Step;
use brooklet_kernels::{FLUID_SHIFT, INACTIVE_FLUID, Position, QUARANTINED, Velocity};
use glam::DVec3;

/// A particle's state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Particle {
    /// Relative to the domain's lowest corner.
    pub position_m: DVec3,
    /// Velocity, m/s.
    pub velocity_m_s: DVec3,
    /// Its state was not finite: it is parked where it was, or at the origin, at rest, and listed by nobody.
    pub quarantined: bool,
    /// The slot holds no particle.
    pub inactive: bool,
    /// Time since the particle began, where the solver counts it, s.
    pub age_s: f64,
    /// Of its last substep, where the solver's next one takes of it, m/s²; none of a particle that had none yet.
    pub acceleration_m_s2: Option<DVec3>,
    /// Of its last substep, where the solver begins the next one with a share of it.
    pub pressure: Pressure,
    /// With which DFSPH's divergence and density solve of its last substep ended: multipliers without unit.
    pub multipliers: [f64; 2],
}

/// What the corrections of a substep came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pressure {
    /// What they moved a particle by, over dt².
    pub acceleration_m_s2: DVec3,
    /// All its lambdas, over dt².
    pub multiplier_per_s2: f64,
}

impl Particle {
    /// Of the words that the GPU keeps of it.
    pub fn of(position: &Position, velocity: &Velocity) -> Self {
        Self {
            position_m: DVec3::from_array(position.position_m.map(f64::from)),
            velocity_m_s: DVec3::from_array(velocity.velocity_m_s.map(f64::from)),
            quarantined: position.tag & QUARANTINED != 0,
            inactive: position.tag >> FLUID_SHIFT & INACTIVE_FLUID == INACTIVE_FLUID,
            age_s: f64::from(velocity.age_s),
            ..Self::default()
        }
    }

    /// What becomes of it when its state is not finite.
    pub fn parked(&self) -> Self {
        let position_m = if self.position_m.is_finite() { self.position_m } else { DVec3::ZERO };
        Self { position_m, quarantined: true, ..Self::default() }
    }

    /// Whether it takes part.
    pub fn is_simulated(&self) -> bool {
        !self.quarantined && !self.inactive
    }
}

/// What became of a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Predicted {
    /// Its state at the substep's end, were it alone.
    pub particle: Particle,
    /// Whether its speed was limited.
    pub slowed: bool,
}

/// Predicts one particle.
pub fn predict(before: Particle, step: &Step) -> Predicted {
    if !before.is_simulated() {
        return Predicted { particle: before, slowed: false };
    }
    if !before.position_m.is_finite() || !before.velocity_m_s.is_finite() {
        let particle = before.parked();
        return Predicted { particle, slowed: false };
    }
    let (velocity_m_s, slowed) = step.slowed(before.velocity_m_s + step.gravity_m_s2 * step.dt_s);
    let free_m = before.position_m + velocity_m_s * step.dt_s;
    let (position_m, velocity_m_s) = confine_path(free_m, velocity_m_s, step);
    let particle = Particle { position_m: step.wrapped(position_m), velocity_m_s, ..before };
    Predicted { particle, slowed }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::BVec3;

    fn step(walls: bool) -> Step {
        Step {
            gravity_m_s2: DVec3::new(0.0, -9.81, 0.0),
            dt_s: 1.0 / 240.0,
            domain_size_m: DVec3::new(2.0, 1.0, 1.0),
            walls: if walls { BVec3::TRUE } else { BVec3::FALSE },
            period_m: DVec3::ZERO,
            wall_offset_m: 0.005,
            max_speed_m_s: 100.0,
        }
    }

    fn at_rest(position_m: DVec3) -> Particle {
        Particle { position_m, ..Particle::default() }
    }

    #[test]
    fn free_fall_is_the_integrators_closed_form() {
        // Symplectic Euler from rest: after n substeps v = n g dt and x = n (n + 1) / 2 g dt^2.
        let step = step(false);
        let mut particle = at_rest(DVec3::ZERO);
        for n in 1..=100 {
            particle = predict(particle, &step).particle;
            let n = f64::from(n);
            let v = step.gravity_m_s2 * step.dt_s * n;
            let x = step.gravity_m_s2 * step.dt_s.powi(2) * (n * (n + 1.0) / 2.0);
            assert!((particle.velocity_m_s - v).length() < 1e-13);
            assert!((particle.position_m - x).length() < 1e-13);
        }
    }

    #[test]
    fn a_wall_stops_what_runs_into_it() {
        let mut particle = at_rest(DVec3::new(1.0, 0.006, 0.5));
        particle.velocity_m_s = DVec3::new(1.0, -2.0, 0.0);
        let step = step(true);
        let after = predict(particle, &step).particle;
        assert_eq!(after.position_m.y, step.wall_offset_m);
        let travelled = (after.position_m - particle.position_m) / step.dt_s;
        assert!((after.velocity_m_s - travelled).length() < 1e-12);
        assert_eq!(after.velocity_m_s.x, 1.0);
    }

    #[test]
    fn what_leaves_a_periodic_side_comes_in_on_the_other() {
        let mut step = Step { gravity_m_s2: DVec3::ZERO, period_m: DVec3::new(2.0, 0.0, 1.0), ..step(false) };
        let mut particle = at_rest(DVec3::new(1.99, 0.99, 0.005));
        particle.velocity_m_s = DVec3::new(4.0, 4.0, -4.0);
        let after = predict(particle, &step).particle;
        let expected = DVec3::new(1.99 - 2.0 + 4.0 / 240.0, 0.99 + 4.0 / 240.0, 1.005 - 4.0 / 240.0);
        assert!((after.position_m - expected).length() < 1e-15, "{}", after.position_m);
        assert_eq!(after.velocity_m_s, particle.velocity_m_s);
        // Never onto the far side itself.
        step.dt_s = 1e-20;
        assert_eq!(
            predict(at_rest(DVec3::new(-1e-20, 0.5, 2.0)), &step).particle.position_m,
            DVec3::new(0.0, 0.5, 0.0)
        );
    }

    #[test]
    fn limits_speed_and_quarantines() {
        let mut particle = at_rest(DVec3::splat(0.5));
        particle.velocity_m_s = DVec3::new(300.0, 0.0, 400.0);
        let after = predict(particle, &step(false));
        assert!(after.slowed);
        assert!((after.particle.velocity_m_s.length() - 100.0).abs() < 1e-12);
        particle.velocity_m_s.y = f64::NAN;
        let after = predict(particle, &step(false)).particle;
        assert!(after.quarantined);
        assert_eq!(after.position_m, particle.position_m, "where it was");
        particle.position_m.x = f64::INFINITY;
        assert_eq!(predict(particle, &step(false)).particle.position_m, DVec3::ZERO);
        assert_eq!(after.velocity_m_s, DVec3::ZERO);
    }
}
