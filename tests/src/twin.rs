//! A scene as the f64 twin of the whole chain.

use brooklet_fluid::Scene;
use brooklet_fluid::particles::ParticleSet;
use brooklet_kernels::{Position, Velocity};
use brooklet_reference::step::Fluid;
use brooklet_study::{Setup, backend::reference_fluid};

/// The twin of `scene` with these particles, in their order.
pub fn twin(scene: &Scene, positions: &[Position], velocities: &[Velocity]) -> Fluid {
    let particles = ParticleSet { positions: positions.to_vec(), velocities: velocities.to_vec() };
    reference_fluid(&Setup {
        scene: scene.clone(),
        particles,
        sample_times_s: Vec::new(),
        relaxes: false,
        squeezed: false,
    })
}
