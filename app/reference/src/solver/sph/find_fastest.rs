//! What limits the next substep. (Shader: `solver/sph/find_fastest.compute`.)

use crate::particles::predict::Particle;

/// The largest speed, m/s, and acceleration, m/s², of those that have one.
pub fn find_fastest(particles: &[Particle]) -> [f64; 2] {
    let accelerated = particles.iter().filter(|particle| particle.is_simulated()).filter_map(|particle| {
        particle.acceleration_m_s2.map(|by_m_s2| [particle.velocity_m_s.length(), by_m_s2.length()])
    });
    accelerated.fold([0.0; 2], |most, one| [0, 1].map(|k| f64::max(most[k], one[k])))
}
