//! Position Based Fluids (Macklin & Muller 2013), stage by stage. Lengths are in units of h where
//! no unit is named, densities are ratios to the rest density.

pub mod coarse_correction;
pub mod constrain_density;
pub mod correct_positions;
pub mod momentum;
pub mod substep;
pub mod update_velocity;
pub mod warm_start;
