//! Particles that age, fall, are dragged and bounce. (Shader: `solver/none/integrate_particles.compute`.)

use crate::boundary::bounce_path;
use crate::params::{NonInteracting, Step};
use crate::particles::predict::{Particle, Predicted};

/// The particle with this id after a substep.
pub fn integrate_particles(id: u32, before: Particle, step: &Step, settings: &NonInteracting) -> Predicted {
    let unslowed = |particle| Predicted { particle, slowed: false };
    if !before.is_simulated() {
        return unslowed(before);
    }
    if !before.position_m.is_finite() || !before.velocity_m_s.is_finite() {
        return unslowed(before.parked());
    }
    let age_s = before.age_s + step.dt_s;
    if settings.lifetime_s > 0.0 && age_s >= settings.lifetime_of_s(id) {
        return unslowed(Particle { inactive: true, position_m: before.position_m, ..Particle::default() });
    }
    let free_m_s = (before.velocity_m_s + step.gravity_m_s2 * step.dt_s) * (-settings.drag_per_s * step.dt_s).exp();
    let (velocity_m_s, slowed) = step.slowed(free_m_s);
    let free_m = before.position_m + velocity_m_s * step.dt_s;
    let (position_m, velocity_m_s) = bounce_path(free_m, velocity_m_s, settings.restitution, step);
    let particle = Particle { position_m: step.wrapped(position_m), velocity_m_s, age_s, ..before };
    Predicted { particle, slowed }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{BVec3, DVec3};

    fn step(dt_s: f64) -> Step {
        Step {
            gravity_m_s2: DVec3::new(0.0, -9.81, 0.0),
            dt_s,
            domain_size_m: DVec3::ONE,
            walls: BVec3::TRUE,
            period_m: DVec3::ZERO,
            wall_offset_m: 0.0,
            max_speed_m_s: 100.0,
        }
    }

    #[test]
    fn a_bounce_gives_back_the_square_of_the_restitution_in_height() {
        let step = step(1e-4);
        for restitution in [0.0, 0.5, 0.8, 1.0] {
            let settings = NonInteracting { restitution, ..NonInteracting::default() };
            let mut ball = Particle { position_m: DVec3::new(0.5, 0.5, 0.5), ..Particle::default() };
            let (mut has_bounced, mut highest_m) = (false, 0.0_f64);
            for _ in 0..7000 {
                let falls = ball.velocity_m_s.y <= 0.0;
                ball = integrate_particles(0, ball, &step, &settings).particle;
                has_bounced |= falls && ball.velocity_m_s.y > 0.0 || ball.position_m.y == 0.0;
                if has_bounced {
                    highest_m = highest_m.max(ball.position_m.y);
                }
            }
            // A step of 1e-4 s at 3.1 m/s.
            assert!((highest_m - 0.5 * restitution * restitution).abs() < 1e-3, "{restitution}: {highest_m}");
        }
    }

    #[test]
    fn drag_is_exponential_and_lives_end_between_their_bounds() {
        let step = Step { gravity_m_s2: DVec3::ZERO, walls: BVec3::FALSE, ..step(0.01) };
        let settings = NonInteracting { drag_per_s: 2.0, lifetime_s: 1.0, lifetime_variation: 0.5, restitution: 0.0 };
        let mut ends_s = Vec::new();
        for id in 0..200 {
            let mut spark = Particle { velocity_m_s: DVec3::X, ..Particle::default() };
            let mut steps = 0;
            while spark.is_simulated() {
                steps += 1;
                let expected = (-2.0 * 0.01 * f64::from(steps)).exp();
                spark = integrate_particles(id, spark, &step, &settings).particle;
                assert!(!spark.is_simulated() || (spark.velocity_m_s.x - expected).abs() < 1e-12);
            }
            assert!(spark.inactive && !spark.quarantined);
            ends_s.push(0.01 * f64::from(steps));
        }
        let (first, last) = ends_s.iter().fold((f64::MAX, 0.0_f64), |(a, b), &end| (a.min(end), b.max(end)));
        assert!((0.5..0.52).contains(&first) && (0.98..=1.01).contains(&last), "{first} {last}");
    }
}
