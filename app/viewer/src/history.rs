//! The last values of what is shown over time, and where half and 95 of 100 of them lie.

use std::collections::VecDeque;

/// Values over time, the oldest dropped.
#[derive(Clone, Debug, Default)]
pub struct History {
    values: VecDeque<[f64; 2]>,
}

/// Frames that are looked back at: four seconds at 60 a second.
const KEPT: usize = 240;

impl History {
    /// Adds `value` at `time_s`; what is not finite is a gap.
    pub fn push(&mut self, time_s: f64, value: f64) {
        if self.values.len() == KEPT {
            self.values.pop_front();
        }
        if value.is_finite() {
            self.values.push_back([time_s, value]);
        }
    }

    /// Time and value, oldest first.
    pub fn points(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.values.iter().copied()
    }

    /// The newest value.
    pub fn last(&self) -> Option<f64> {
        self.values.back().map(|[_, value]| *value)
    }

    /// Median and 95th percentile (nearest rank).
    pub fn quantiles(&self) -> Option<Quantiles> {
        let mut values: Vec<f64> = self.values.iter().map(|[_, value]| *value).collect();
        values.sort_unstable_by(f64::total_cmp);
        let at = |share: f64| values.get(((share * values.len() as f64).ceil() as usize).saturating_sub(1)).copied();
        Some(Quantiles { p50: at(0.5)?, p95: at(0.95)? })
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.values.clear();
    }
}

/// Half of the values are no larger, and 95 of 100.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantiles {
    /// Median.
    pub p50: f64,
    /// 95th percentile.
    pub p95: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_newest_are_kept_and_ranked() {
        let mut history = History::default();
        assert_eq!(history.quantiles(), None);
        for index in 0..1000 {
            history.push(f64::from(index), f64::from(index));
        }
        history.push(1000.0, f64::NAN);
        assert_eq!(history.points().count(), KEPT - 1, "a gap takes the place of the oldest");
        assert_eq!(history.last(), Some(999.0));
        let Quantiles { p50, p95 } = history.quantiles().unwrap();
        assert!((p50 - 880.0).abs() < 1.0 && (p95 - 988.0).abs() < 1.0, "{p50} {p95}");
        history.clear();
        assert_eq!(history.last(), None);
    }
}
