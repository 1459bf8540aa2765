// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from all shaders.
//! Choices among keywords, of which one is on.

/// `#pragma multi_compile _ RELAXED_PRECISION HALF_PRECISION`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PrecisionKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `RELAXED_PRECISION` is on.
    RelaxedPrecision,
    /// `HALF_PRECISION` is on.
    HalfPrecision,
}
