//! Particles that do not interact.

pub mod integrate_particles;
