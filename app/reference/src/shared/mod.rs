//! What several stages need: the smoothing kernel, sums over the lattice, quadrature.

pub mod cells;
pub mod hash;
pub mod lattice;
pub mod list;
pub mod parallel;
pub mod quadrature;
pub mod quantized_position;
pub mod wendland;
