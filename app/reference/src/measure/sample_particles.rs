//! Every stride-th particle, at an index of its own. (Shader: `measure/sample_particles.compute`.)

use crate::particles::predict::Particle;
use glam::DVec3;

/// Position and speed of the particles whose id is a multiple of `stride`, at id / stride; none where
/// nobody has the id or the particle takes no part. `ids` are below the number of particles.
pub fn sample_particles(particles: &[Particle], ids: &[usize], stride: usize) -> Vec<Option<(DVec3, f64)>> {
    let mut samples = vec![None; particles.len().div_ceil(stride)];
    for (particle, id) in particles.iter().zip(ids) {
        if id % stride == 0 && particle.is_simulated() {
            samples[id / stride] = Some((particle.position_m, particle.velocity_m_s.length()));
        }
    }
    samples
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_particle_keeps_its_place_however_they_are_sorted() {
        let particle = |id: usize| Particle {
            position_m: DVec3::splat(id as f64),
            velocity_m_s: DVec3::new(0.0, 3.0, 4.0) * id as f64,
            quarantined: id == 3,
            ..Particle::default()
        };
        let expected = [Some((DVec3::ZERO, 0.0)), None, Some((DVec3::splat(6.0), 30.0))];
        for ids in [[0, 1, 2, 3, 4, 5, 6], [6, 3, 5, 0, 1, 2, 4]] {
            assert_eq!(sample_particles(&ids.map(particle), &ids, 3), expected);
        }
    }
}
