//! Solvers.

pub mod pbf;
