//! What limits the next substep. (Shader: `solver/sph/find_fastest.compute`.)

use crate::particles::predict::Particle;

/// The largest speed, m/s, and acceleration, m/s², of those that have one.
pub fn find_fastest(particles: &[Particle]) -> [f64; 2] {
    particles.iter().filter(|particle| particle.is_simulated()).fold(
        [0.0, 0.0],
        |[fastest_m_s, strongest_m_s2], one| match one.acceleration_m_s2 {
            Some(acceleration_m_s2) => {
                [one.velocity_m_s.length().max(fastest_m_s), acceleration_m_s2.length().max(strongest_m_s2)]
            }
            None => [fastest_m_s, strongest_m_s2],
        },
    )
}
