//! A substep that begins with a share of the last one's pressure. (Shaders: `start_warm`, `keep_pressure`.)

use crate::boundary::confine_position;
use crate::params::{Pbf, Step};
use crate::particles::predict::Pressure;
use glam::DVec3;

/// Where a particle that was predicted at a place begins its iterations, and the sum of lambdas that stands before them.
pub fn start_warm(predicted_m: DVec3, pressure: &Pressure, step: &Step, pbf: &Pbf) -> (DVec3, f64) {
    let share = pbf.warm_start * step.dt_s.powi(2);
    let displacement_m = share * pressure.acceleration_m_s2;
    let cut = (pbf.max_correction_m / displacement_m.length().max(f64::MIN_POSITIVE)).min(1.0);
    (confine_position(predicted_m + cut * displacement_m, step), cut * share * pressure.multiplier_per_s2)
}

/// What the next substep may begin with of a particle that the corrections moved, and whose lambdas add up to `total`.
pub fn keep_pressure(predicted_m: DVec3, corrected_m: DVec3, total: f64, dt_s: f64) -> Pressure {
    let inverse_dt_squared = dt_s.powi(-2);
    Pressure {
        acceleration_m_s2: (corrected_m - predicted_m) * inverse_dt_squared,
        multiplier_per_s2: total * inverse_dt_squared,
    }
}
