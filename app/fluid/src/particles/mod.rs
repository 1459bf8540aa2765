//! Particles: where they start, and the prediction that begins each substep.

mod emit;

pub(crate) use emit::fits;
pub use emit::{Emitted, MAX_FLUIDS, MAX_PARTICLES, count, emit};
