//! Two ways to the same result, run in turn.

use brooklet_gpu::{Engine, FrameReport, Gpu, Plan, Quantiles, Recording, RecordingId, Resources};
use serde::Serialize;

use crate::{BenchError, Observer};

/// What two ways came to.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// What is tried.
    pub optimisation: &'static str,
    /// On what.
    pub case: String,
    /// The product's way.
    pub baseline: &'static str,
    /// The other way.
    pub alternative: &'static str,
    /// Median time of the baseline, ms.
    pub baseline_ms: f64,
    /// Median time of the alternative, ms.
    pub alternative_ms: f64,
    /// The alternative's time over the baseline's of each pair: the median,
    pub ratio: f64,
    /// what 10 of 100 pairs stay below,
    pub ratio_p10: f64,
    /// and what 90 of 100 do.
    pub ratio_p90: f64,
    /// Pairs that gave usable times.
    pub pairs: usize,
}

/// The names that go into an outcome.
pub struct Names {
    pub optimisation: &'static str,
    pub case: String,
    pub baseline: &'static str,
    pub alternative: &'static str,
}

/// What a contest runs.
pub struct Ways {
    /// Uploads, run once.
    pub init: Recording,
    /// The product's way.
    pub baseline: Recording,
    /// The other way.
    pub alternative: Recording,
}

impl Ways {
    /// Three empty recordings.
    pub fn declare(resources: &mut Resources) -> Self {
        Self {
            init: resources.recording("init"),
            baseline: resources.recording("baseline"),
            alternative: resources.recording("alternative"),
        }
    }
}

/// Runs pairs of recordings on a device.
pub struct Ring<'a> {
    pub gpu: &'a Gpu,
    pub observer: &'a dyn Observer,
    pub pairs: usize,
}

/// Pairs that are run before those that count.
const WARM_UP: usize = 3;

impl Ring<'_> {
    /// Runs both ways in turn, once each way round, `pairs` times; `check` looks at the results
    /// of the first pair.
    pub fn compare(
        &self,
        names: Names,
        resources: Resources,
        ways: Ways,
        check: impl FnOnce(&mut Engine) -> Result<(), BenchError>,
    ) -> Result<Outcome, BenchError> {
        let [init, baseline, alternative] = [&ways.init, &ways.baseline, &ways.alternative].map(Recording::id);
        let plan = Plan::sweep(resources, vec![ways.init, ways.baseline, ways.alternative], &[])
            .map_err(BenchError::stopped)?;
        let mut engine = Engine::new(self.gpu, plan).map_err(BenchError::input)?;
        engine.run(&[init], &[]).map_err(BenchError::stopped)?;
        engine.run(&[baseline, alternative], &[]).map_err(BenchError::stopped)?;
        check(&mut engine)?;
        let mut reports = engine.finish().map_err(BenchError::stopped)?;
        reports.clear();
        for pair in 0..WARM_UP + self.pairs {
            self.observer.check()?;
            // What ran before leaves the caches as it does: so each goes first as often.
            let order = if pair % 2 == 0 { [baseline, alternative] } else { [alternative, baseline] };
            engine.run(&order, &[]).map_err(BenchError::stopped)?;
            reports.extend(engine.reports());
        }
        reports.extend(engine.finish().map_err(BenchError::stopped)?);
        let times: Vec<(f64, f64)> = reports
            .iter()
            .skip(WARM_UP)
            .filter_map(|report| Some((ms_of(report, baseline)?, ms_of(report, alternative)?)))
            .collect();
        outcome(names, &times).ok_or_else(|| BenchError::Stopped("the device gave no usable times".into()))
    }
}

/// From the first span of a recording to the end of its last, ms.
fn ms_of(report: &FrameReport, recording: RecordingId) -> Option<f64> {
    let spans = || report.spans.iter().filter(|span| span.recording == recording);
    let begin = spans().map(|span| span.begin_ticks).min()?;
    let end = spans().map(|span| span.end_ticks).max()?;
    (end > begin).then(|| (end - begin) as f64 * report.timestamp_period_ns * 1e-6)
}

fn outcome(names: Names, times: &[(f64, f64)]) -> Option<Outcome> {
    let mut ratios: Vec<f64> = times.iter().map(|(baseline, alternative)| alternative / baseline).collect();
    ratios.sort_unstable_by(f64::total_cmp);
    let last = ratios.len().checked_sub(1)?;
    let rank = |part: f64| ratios[(part * last as f64).round() as usize];
    Some(Outcome {
        optimisation: names.optimisation,
        case: names.case,
        baseline: names.baseline,
        alternative: names.alternative,
        baseline_ms: Quantiles::of(times.iter().map(|(baseline, _)| *baseline).collect())?.median,
        alternative_ms: Quantiles::of(times.iter().map(|(_, alternative)| *alternative).collect())?.median,
        ratio: rank(0.5),
        ratio_p10: rank(0.1),
        ratio_p90: rank(0.9),
        pairs: times.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> Names {
        Names { optimisation: "o", case: String::new(), baseline: "a", alternative: "b" }
    }

    #[test]
    fn ratios_are_of_pairs_not_of_medians() {
        // Both ways slow down together: the ratio does not notice.
        let times: Vec<_> = (1..=11).map(|load| (f64::from(load), 2.0 * f64::from(load))).collect();
        let same = outcome(names(), &times).unwrap();
        assert_eq!((same.ratio, same.ratio_p10, same.ratio_p90, same.pairs), (2.0, 2.0, 2.0, 11));
        assert_eq!((same.baseline_ms, same.alternative_ms), (6.0, 12.0));
        let spread: Vec<_> = (0..=10).map(|i| (1.0, f64::from(i))).collect();
        let spread = outcome(names(), &spread).unwrap();
        assert_eq!((spread.ratio_p10, spread.ratio, spread.ratio_p90), (1.0, 5.0, 9.0));
        assert!(outcome(names(), &[]).is_none());
    }
}
