//! What came and went since a scene began: measurements tell it from one to the next.

use brooklet_fluid::Stats;

/// Particles that came and went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flow {
    /// That emitters emitted.
    pub emitted: u64,
    /// That drains took, or whose lifetime ended.
    pub drained: u64,
    /// For which no slot was free.
    pub lost: u64,
}

impl Flow {
    /// Adds what a measurement tells.
    pub fn take(&mut self, stats: &Stats) {
        self.emitted += u64::from(stats.counters.emitted);
        self.drained += u64::from(stats.counters.drained);
        self.lost += u64::from(stats.counters.capacity_overflow);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_measurements_tell_adds_up() {
        let mut stats = Stats::default();
        (stats.counters.emitted, stats.counters.drained, stats.counters.capacity_overflow) = (7, 2, 1);
        let mut flow = Flow::default();
        flow.take(&stats);
        stats.counters.drained = 0;
        flow.take(&stats);
        assert_eq!(flow, Flow { emitted: 14, drained: 2, lost: 2 });
    }
}
