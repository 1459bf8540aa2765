//! The velocity that the corrections amount to (Macklin & Muller 2013, algorithm 1, line 21).

use crate::params::Step;
use glam::DVec3;

/// What a particle's velocity becomes, and whether its speed was limited.
pub fn update_velocity(predicted_m: DVec3, corrected_m: DVec3, velocity_m_s: DVec3, step: &Step) -> (DVec3, bool) {
    // The prediction already moved by v dt, so (x* - x) / dt is v plus what was corrected.
    step.slowed(velocity_m_s + (corrected_m - predicted_m) / step.dt_s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::BVec3;

    #[test]
    fn is_the_way_travelled() {
        let step = Step {
            gravity_m_s2: DVec3::ZERO,
            dt_s: 0.01,
            domain_size_m: DVec3::ONE,
            walls: BVec3::FALSE,
            period_m: DVec3::ZERO,
            wall_offset_m: 0.0,
            max_speed_m_s: 10.0,
        };
        let (start, velocity) = (DVec3::splat(0.2), DVec3::new(1.0, 2.0, 3.0));
        let predicted = start + velocity * step.dt_s;
        let corrected = predicted + DVec3::new(0.001, 0.0, -0.002);
        let (after, slowed) = update_velocity(predicted, corrected, velocity, &step);
        assert!((after - (corrected - start) / step.dt_s).length() < 1e-12);
        assert!(!slowed);
        let (after, slowed) = update_velocity(predicted, corrected + 1.0, velocity, &step);
        assert!(slowed && (after.length() - 10.0).abs() < 1e-12);
    }
}
