//! What is measured of the particles.

pub mod measure_particles;
pub mod measure_totals;
