//! The particles at one moment, whoever moved them.

use glam::DVec3;

/// The particles at one moment, in the order of their ids.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sample {
    /// Since the start, s.
    pub time_s: f64,
    /// Relative to the domain's lowest corner.
    pub positions_m: Vec<DVec3>,
    /// In the same order.
    pub velocities_m_s: Vec<DVec3>,
    /// Particles that are lost, there twice, not finite, or out of the simulation.
    pub unsound: usize,
    /// What the fluid pushed solids with whose force is measured, step by step since the sample before; none of twins.
    pub forces: Vec<Force>,
}

/// Mean forces of a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Force {
    /// At its end, since the start, s.
    pub time_s: f64,
    /// On each solid whose force is measured, N.
    pub on_solids_n: Vec<DVec3>,
}

impl Sample {
    /// Mean of a quantity over the particles; 0 of none.
    pub fn mean(&self, of: impl Fn(DVec3, DVec3) -> f64) -> f64 {
        let sum: f64 = self.positions_m.iter().zip(&self.velocities_m_s).map(|(&at, &v)| of(at, v)).sum();
        sum / self.positions_m.len().max(1) as f64
    }

    /// Mean of their positions.
    pub fn middle_m(&self) -> DVec3 {
        self.positions_m.iter().sum::<DVec3>() / self.positions_m.len().max(1) as f64
    }

    /// Kinetic energy over mass, m²/s².
    pub fn kinetic_m2_s2(&self) -> f64 {
        self.mean(|_, v| 0.5 * v.length_squared())
    }

    /// Length of the mean velocity in the plane of x and y: what is left of momentum that should be none, m/s.
    pub fn drift_m_s(&self) -> f64 {
        self.mean(|_, v| v.x).hypot(self.mean(|_, v| v.y))
    }

    /// Largest x of any particle and half a spacing, m; spray ahead of the body included.
    pub fn front_m(&self, spacing_m: f64) -> f64 {
        self.positions_m.iter().map(|at| at.x).fold(0.0, f64::max) + 0.5 * spacing_m
    }

    /// The fastest particle, m/s.
    pub fn max_speed_m_s(&self) -> f64 {
        self.velocities_m_s.iter().map(|v| v.length()).fold(0.0, f64::max)
    }

    /// Whether every state is finite and no particle is missing.
    pub fn is_sound(&self) -> bool {
        let finite = |vectors: &[DVec3]| vectors.iter().all(|v| v.is_finite());
        self.unsound == 0 && finite(&self.positions_m) && finite(&self.velocities_m_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_of_all_particles_and_unsound_ones_are_seen() {
        let sample = Sample {
            positions_m: vec![DVec3::X, 3.0 * DVec3::X],
            velocities_m_s: vec![DVec3::ZERO, 2.0 * DVec3::Y],
            ..Sample::default()
        };
        assert_eq!((sample.middle_m(), sample.kinetic_m2_s2(), sample.max_speed_m_s()), (2.0 * DVec3::X, 1.0, 2.0));
        assert!(sample.is_sound());
        assert!(!Sample { unsound: 1, ..sample.clone() }.is_sound());
        assert!(!Sample { velocities_m_s: vec![DVec3::ZERO, DVec3::NAN], ..sample }.is_sound());
        assert_eq!(Sample::default().middle_m(), DVec3::ZERO);
    }
}
