//! What capturing costs, by A/B: the same work with a capture and without, in turns.

use brooklet_gpu::quantile;

/// Medians of both, and how they were come by; stands in the capture as metadata `capture_cost`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CaptureCost {
    /// Median time of what was timed with a capture, ms.
    pub with_ms: f64,
    /// Median time of the same without, ms.
    pub without_ms: f64,
    /// Median of the pairs' ratios, less 1: the share that capturing adds.
    pub share: f64,
    /// Half of the pairs' shares lie between these.
    pub quartiles: [f64; 2],
    /// Pairs that were timed.
    pub pairs: usize,
}

impl CaptureCost {
    /// Of pairs (with, without) in ms, each of two runs that followed each other at once: what drifts in a
    /// machine then drifts for both. None without a usable pair.
    pub fn of_pairs(pairs: &[(f64, f64)]) -> Option<Self> {
        let usable = |(with, without): &&(f64, f64)| *with > 0.0 && *without > 0.0 && (with + without).is_finite();
        let usable: Vec<(f64, f64)> = pairs.iter().filter(usable).copied().collect();
        let shares = sorted(usable.iter().map(|(with, without)| with / without - 1.0));
        Some(Self {
            with_ms: quantile(&sorted(usable.iter().map(|pair| pair.0)), 0.5)?,
            without_ms: quantile(&sorted(usable.iter().map(|pair| pair.1)), 0.5)?,
            share: quantile(&shares, 0.5)?,
            quartiles: [quantile(&shares, 0.25)?, quantile(&shares, 0.75)?],
            pairs: usable.len(),
        })
    }

    /// As it stands in the metadata.
    pub fn fields(&self) -> [(&'static str, String); 6] {
        [
            ("with_ms", format!("{:.6}", self.with_ms)),
            ("without_ms", format!("{:.6}", self.without_ms)),
            ("share", format!("{:.6}", self.share)),
            ("share_quartiles", format!("{:.6} {:.6}", self.quartiles[0], self.quartiles[1])),
            ("pairs", self.pairs.to_string()),
            ("how", "medians; share is the median of the pairs' ratios less 1".into()),
        ]
    }
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_unstable_by(f64::total_cmp);
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drift_that_both_of_a_pair_have_is_no_cost() {
        let pairs: Vec<(f64, f64)> = (0..9).map(|round| f64::from(10 + round)).map(|ms| (1.01 * ms, ms)).collect();
        let cost = CaptureCost::of_pairs(&pairs).unwrap();
        assert!((cost.share - 0.01).abs() < 1e-12 && (cost.without_ms - 14.0).abs() < 1e-12, "{cost:?}");
        assert_eq!(cost.pairs, 9);
        assert_eq!(CaptureCost::of_pairs(&[(1.0, 0.0), (f64::NAN, 1.0)]), None);
    }
}
