//! Particles: where they start, the same fluid at another spacing, and the prediction that begins each substep.

mod lattice;
mod predict;
mod resample;
mod sample_lattice;
mod tag;

pub use predict::predict;
pub use resample::resample;
pub use sample_lattice::{MAX_FLUIDS, MAX_PARTICLES, ParticleSet, count, sample_lattice};
pub(crate) use sample_lattice::{fits, fitted_spacing_m};
pub use tag::{fluid_of, id_of, is_simulated};
