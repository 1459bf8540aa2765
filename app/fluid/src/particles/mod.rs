//! Particles: where they start, the same fluid at another spacing, and the prediction that begins each substep.

mod emit;
mod lattice;
mod resample;

pub(crate) use emit::{fits, smallest_step_m};
pub use emit::{Emitted, MAX_FLUIDS, MAX_PARTICLES, count, emit};
pub use resample::resample;
