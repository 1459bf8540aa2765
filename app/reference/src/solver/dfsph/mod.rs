//! Divergence-free SPH (Bender & Koschier 2015, 2017), with lengths in units of h, densities as ratios to that at rest, and
//! pressures as multipliers without unit: p dt² / (ρ0 h²).

pub mod apply_pressure;
pub mod correct_pressure;
pub mod factor_pressure;
pub mod solve;
pub mod substep;
