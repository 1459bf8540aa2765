//! Smoothed particle hydrodynamics with an equation of state.

pub mod accelerate;
pub mod choose_time_step;
pub mod compute_density;
pub mod find_fastest;
pub mod kernels;
pub mod substep;
