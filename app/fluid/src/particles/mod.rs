//! Particles: where they start, the same fluid at another spacing, and the prediction that begins each substep.

mod emit;
mod lattice;
mod resample;

pub use emit::{Emitted, MAX_FLUIDS, MAX_PARTICLES, count, emit};
pub(crate) use emit::{fits, fitted_spacing_m};
pub use resample::resample;
