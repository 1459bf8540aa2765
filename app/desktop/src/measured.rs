//! What was measured of the fluid over a run: the last state, the worst, and what was counted.

use brooklet_fluid::{Stats, measure::Summary};
use serde::Serialize;

fn raise(summary: &mut Option<Summary>, other: Summary) {
    let summary = summary.get_or_insert_default();
    summary.mean = summary.mean.max(other.mean);
    summary.p99 = summary.p99.max(other.p99);
    summary.max = summary.max.max(other.max);
}

/// The largest values of a run, each on its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    /// Of |rho/rho0 - 1|.
    pub density_error: Option<Summary>,
    /// Of max(rho/rho0 - 1, 0).
    pub compression: Option<Summary>,
    /// Largest speed.
    pub max_speed_m_s: f64,
}

/// Everything that was counted instead of hidden. All but the last two are sums over the run, the last
/// two, which are how many particles it was at the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counted {
    /// Neighbours that had no slot.
    pub neighbour_overflow: u64,
    /// Speeds that were clamped.
    pub speed_clamps: u64,
    /// Corrections that were clamped.
    pub correction_clamps: u64,
    /// Displacements of a substep that were held below the support radius.
    pub displacement_clamps: u64,
    /// Searches for neighbours among too many candidates to look at all.
    pub crowded: u64,
    /// Substeps longer than an explicit solver's limit: what follows is unstable.
    pub long_substeps: u64,
    /// Iterations of pressure solves that hold the density.
    pub density_iterations: u64,
    /// Of those that hold its change.
    pub divergence_iterations: u64,
    /// Pressure solves that ended above their tolerance.
    pub unsolved: u64,
    /// Particles that emitters emitted.
    pub emitted: u64,
    /// Particles that drains took, or whose lifetime ended.
    pub drained: u64,
    /// Particles for which no slot was free.
    pub capacity_overflow: u64,
    /// Diffuse particles that were spawned.
    pub diffuse_spawned: u64,
    /// Those whose lifetime ended, or that left.
    pub diffuse_ended: u64,
    /// Those that younger ones took the slot of.
    pub diffuse_overwritten: u64,
    /// Those for which a step had no slot left.
    pub diffuse_dropped: u64,
    /// Particles whose state was not finite.
    pub quarantined: u64,
    /// Particles outside an open domain.
    pub escaped: u64,
}

impl Counted {
    /// What of it makes all other figures doubtful, in a line.
    pub fn instability(&self) -> Option<String> {
        (self.long_substeps > 0).then(|| {
            format!(
                "unstable: {} substeps were longer than the solver's limits allow (sound, viscosity, force, surface tension); \
                 a shorter solver.dt_s, more solver.substeps or solver.sph.adaptive_substeps = true helps",
                self.long_substeps
            )
        })
    }
}

/// The measurements of a run.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// How many there were.
    pub count: u64,
    /// Step of the last one.
    pub last_step: u64,
    /// The last one.
    pub last: Option<Stats>,
    /// The worst of them.
    pub worst: Worst,
    /// What was counted.
    pub counted: Counted,
}

impl Measured {
    /// Takes the measurement after step `step`.
    pub fn add(&mut self, step: u64, stats: Stats) {
        self.count += 1;
        self.last_step = step;
        self.last = Some(stats);
        if stats.has_density {
            raise(&mut self.worst.density_error, stats.density_error);
            raise(&mut self.worst.compression, stats.compression);
        }
        self.worst.max_speed_m_s = self.worst.max_speed_m_s.max(stats.max_speed_m_s);
        let counters = stats.counters;
        self.counted.neighbour_overflow += u64::from(counters.neighbour_overflow);
        self.counted.speed_clamps += u64::from(counters.speed_clamps);
        self.counted.correction_clamps += u64::from(counters.correction_clamps);
        self.counted.displacement_clamps += u64::from(counters.displacement_clamps);
        self.counted.crowded += u64::from(counters.crowded);
        self.counted.long_substeps += u64::from(counters.long_substeps);
        self.counted.density_iterations += u64::from(counters.density_iterations);
        self.counted.divergence_iterations += u64::from(counters.divergence_iterations);
        self.counted.unsolved += u64::from(counters.unsolved);
        self.counted.emitted += u64::from(counters.emitted);
        self.counted.drained += u64::from(counters.drained);
        self.counted.capacity_overflow += u64::from(counters.capacity_overflow);
        self.counted.diffuse_spawned += u64::from(counters.diffuse_spawned);
        self.counted.diffuse_ended += u64::from(counters.diffuse_ended);
        self.counted.diffuse_overwritten += u64::from(counters.diffuse_overwritten);
        self.counted.diffuse_dropped += u64::from(counters.diffuse_dropped);
        self.counted.quarantined = u64::from(stats.quarantined);
        self.counted.escaped = u64::from(stats.escaped);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stats(compression: f64, speed_clamps: u32, quarantined: u32) -> Stats {
        let mut stats = Stats { has_density: true, max_speed_m_s: 1.0 - compression, quarantined, ..Stats::default() };
        stats.compression.max = compression;
        stats.counters.speed_clamps = speed_clamps;
        stats.counters.long_substeps = 2;
        stats
    }

    #[test]
    fn the_last_the_worst_and_the_sums() {
        let mut measured = Measured::default();
        for (step, compression) in [(4, 0.1), (8, 0.3), (12, 0.2)] {
            measured.add(step, stats(compression, 5, step as u32));
        }
        assert_eq!((measured.count, measured.last_step), (3, 12));
        assert_eq!(measured.last.unwrap().compression.max, 0.2);
        assert_eq!(measured.worst.compression.unwrap().max, 0.3);
        assert_eq!(measured.worst.max_speed_m_s, 0.9);
        assert_eq!((measured.counted.speed_clamps, measured.counted.long_substeps), (15, 6));
        assert_eq!(measured.counted.quarantined, 12, "a state, not a sum");
        assert!(measured.counted.instability().is_some_and(|word| word.contains("6 substeps")));
        assert_eq!(Counted::default().instability(), None);
    }
}
