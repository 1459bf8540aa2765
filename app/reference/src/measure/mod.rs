//! What is measured of the particles.

pub mod density;
pub mod density_ratios;
pub mod measure_particles;
pub mod measure_totals;
pub mod sample_particles;
