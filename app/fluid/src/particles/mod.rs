//! Particles: where they start, the same fluid at another spacing, and the prediction that begins each substep.

mod emit;
mod resample;

pub(crate) use emit::fits;
pub use emit::{Emitted, MAX_FLUIDS, MAX_PARTICLES, count, emit};
pub use resample::resample;
