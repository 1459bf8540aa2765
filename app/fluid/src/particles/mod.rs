//! Particles: where they start, and the prediction that begins each substep.

mod emit;

pub use emit::{Emitted, MAX_PARTICLES, emit};
