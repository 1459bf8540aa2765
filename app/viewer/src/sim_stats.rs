//! What captures say of the simulation (`/sim/stats`), of the window and of a run alike.

use brooklet_capture::StatField;
use brooklet_fluid::{STAT_FIELDS, Stats};

/// The fields of `/sim/stats`: which step it was, when in the simulation, and the measurement.
pub fn fields() -> Vec<StatField> {
    let clock = [
        StatField::new("step", "1", "Number of the step that was measured"),
        StatField::new("simulated_s", "s", "Simulated time"),
    ];
    let stats = STAT_FIELDS.iter().map(|field| StatField::new(field.name, field.unit, field.description));
    clock.into_iter().chain(stats).collect()
}

/// The values of [`fields`], in their order.
pub fn values(step: u64, simulated_s: f64, stats: &Stats) -> Vec<f64> {
    let clock = [step as f64, simulated_s];
    clock.into_iter().chain(STAT_FIELDS.iter().map(|field| (field.value)(stats))).collect()
}
