//! Solvers: what turns sorted, listed particles into their next positions and velocities.

pub mod pbf;
