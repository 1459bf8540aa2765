//! What the program counted over a run.

use std::fmt;

use brooklet_kernels::Counters;

/// Events, summed over a run's measurements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counted {
    /// Neighbours without a slot.
    pub neighbour_overflow: u64,
    /// Searches among too many candidates to look at all.
    pub crowded: u64,
    /// Clamped speeds.
    pub speed_clamps: u64,
    /// Clamped corrections.
    pub correction_clamps: u64,
    /// Displacements of a substep held below the support radius.
    pub displacement_clamps: u64,
    /// Substeps longer than an explicit solver's limit.
    pub long_substeps: u64,
}

impl Counted {
    /// With those of another measurement.
    pub fn and(self, counters: &Counters) -> Self {
        Self {
            neighbour_overflow: self.neighbour_overflow + u64::from(counters.neighbour_overflow),
            crowded: self.crowded + u64::from(counters.crowded),
            speed_clamps: self.speed_clamps + u64::from(counters.speed_clamps),
            correction_clamps: self.correction_clamps + u64::from(counters.correction_clamps),
            displacement_clamps: self.displacement_clamps + u64::from(counters.displacement_clamps),
            long_substeps: self.long_substeps + u64::from(counters.long_substeps),
        }
    }
}

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} neighbours without a slot, {} crowded searches, {} speeds, {} corrections and {} displacements clamped, \
             {} substeps above their limit",
            self.neighbour_overflow,
            self.crowded,
            self.speed_clamps,
            self.correction_clamps,
            self.displacement_clamps,
            self.long_substeps
        )
    }
}
