//! Particles: where they start, the same fluid at another spacing, and the prediction that begins each substep.

mod advect;
pub(crate) mod buffers;
mod predict;
mod resample;
mod sample_lattice;
mod tag;

pub use advect::advect;
pub use predict::predict;
pub use resample::resample;
pub use sample_lattice::{ParticleSet, sample_lattice};
pub use tag::{fluid_of, id_of, is_inactive, is_quarantined, is_simulated};
