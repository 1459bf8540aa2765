//! Medians and percentiles of GPU times over a run.

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};

use crate::{FrameReport, PassInfo, RecordingId, TimingStatus};

/// The frames at the start that medians leave out: the device's clock rises and caches fill then.
/// At most ten, and at most a quarter of the run.
pub fn warm_up_frames(frames: u64) -> u64 {
    (frames / 4).min(10)
}

/// Times of one kind over a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Quantiles {
    /// Half of the frames took no longer.
    pub median: f64,
    /// 95 of 100 frames took no longer.
    pub p95: f64,
}

impl Quantiles {
    /// Of some values; none of none.
    pub fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_unstable_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let middle = values.len() / 2;
        let median = if values.len() % 2 == 1 { values[middle] } else { 0.5 * (values[middle - 1] + values[middle]) };
        // Nearest rank: a time that was really measured.
        let rank = (0.95 * values.len() as f64).ceil() as usize;
        Some(Self { median, p95: values[rank.saturating_sub(1).min(last)] })
    }
}

/// Of values that rise, so large a share of which is no larger: between the two that are nearest. None of none.
pub fn quantile(sorted: &[f64], share: f64) -> Option<f64> {
    let place = share * sorted.len().checked_sub(1)? as f64;
    let (below, above) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    Some(below + (above - below) * place.fract())
}

/// What summaries and benchmarks say of a pass.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PassTimes {
    /// All its dispatches of a frame together, ms; none if it was not timed.
    pub median_ms: Option<f64>,
    /// 95 of 100 frames took no longer, ms.
    pub p95_ms: Option<f64>,
    /// Dispatches in one run of its recording.
    pub dispatches: u32,
    /// Over the whole run, ms.
    pub total_ms: Option<f64>,
}

/// Passes by their stage's name, in order of their first run; an object in JSON.
#[derive(Clone, Debug)]
pub struct Passes<P>(pub Vec<(&'static str, P)>);

impl<P: Serialize> Serialize for Passes<P> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(stage, pass)| (stage, pass)))
    }
}

/// The stages of `passes` in order of their first run, and how often one run of their recordings runs each.
pub fn stages(passes: impl IntoIterator<Item = PassInfo>) -> Vec<(&'static str, u32)> {
    let mut stages: Vec<(&'static str, u32)> = Vec::new();
    for pass in passes {
        match stages.iter_mut().find(|(stage, _)| *stage == pass.stage) {
            Some((_, count)) => *count += pass.count,
            None => stages.push((pass.stage, pass.count)),
        }
    }
    stages
}

/// One value of each frame it was measured in.
type Series = Vec<(u64, f64)>;

/// Collects the times of the frames as they are reported.
#[derive(Debug)]
pub struct Timings {
    warm_up: u64,
    frames: u64,
    flagged_spans: u64,
    status: TimingStatus,
    steps: Series,
    stages: BTreeMap<&'static str, Series>,
}

impl Timings {
    /// For a run whose first `warm_up` frames do not count.
    pub fn new(warm_up: u64) -> Self {
        Self {
            warm_up,
            frames: 0,
            flagged_spans: 0,
            status: TimingStatus::Off,
            steps: Series::new(),
            stages: BTreeMap::new(),
        }
    }

    /// Takes the next frame; `step` is the recording whose spans are a step.
    pub fn add(&mut self, report: &FrameReport, step: RecordingId) {
        let index = self.frames;
        self.frames += 1;
        self.flagged_spans += report.flagged() as u64;
        self.status = report.timing;
        let spans = || report.spans.iter().filter(|span| span.recording == step);
        let begin = spans().map(|span| span.begin_ticks).min();
        let end = spans().map(|span| span.end_ticks).max();
        if let (Some(begin), Some(end)) = (begin, end)
            && end > begin
        {
            let ms = (end - begin) as f64 * report.timestamp_period_ns * 1e-6;
            self.steps.push((index, ms));
        }
        for (stage, ms, _) in report.stage_ms() {
            self.stages.entry(stage).or_default().push((index, ms));
        }
    }

    /// A step, from its first span's begin to its last one's end, ms.
    pub fn step_ms(&self) -> Option<Quantiles> {
        self.quantiles(&self.steps)
    }

    /// A stage, all its dispatches of a frame together, ms.
    pub fn stage_ms(&self, stage: &str) -> Option<Quantiles> {
        self.quantiles(self.stages.get(stage)?)
    }

    /// A stage over the whole run, ms.
    pub fn total_ms(&self, stage: &str) -> f64 {
        self.stages.get(stage).into_iter().flatten().map(|(_, ms)| ms).sum()
    }

    /// What is said of each of a plan's stages, given with their dispatches.
    pub fn passes(&self, stages: &[(&'static str, u32)]) -> Passes<PassTimes> {
        Passes(stages.iter().map(|&(stage, dispatches)| (stage, self.pass(stage, dispatches))).collect())
    }

    /// What is said of a stage that a recording dispatches `dispatches` times.
    pub fn pass(&self, stage: &str, dispatches: u32) -> PassTimes {
        let times = self.stage_ms(stage);
        PassTimes {
            median_ms: times.map(|times| times.median),
            p95_ms: times.map(|times| times.p95),
            dispatches,
            total_ms: times.map(|_| self.total_ms(stage)),
        }
    }

    /// A stage's shortest frame after the warm-up, ms.
    pub fn least_ms(&self, stage: &str) -> Option<f64> {
        let frames = self.stages.get(stage)?.iter();
        frames.filter(|(frame, ms)| *frame >= self.warm_up && *ms > 0.0).map(|(_, ms)| *ms).min_by(f64::total_cmp)
    }

    /// Frames that were reported.
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// Frames at the start that do not count.
    pub fn warm_up(&self) -> u64 {
        self.warm_up.min(self.frames)
    }

    /// Spans that cannot be right.
    pub fn flagged_spans(&self) -> u64 {
        self.flagged_spans
    }

    /// How the times were taken.
    pub fn status(&self) -> TimingStatus {
        self.status
    }

    /// A stage that ran in the warm-up alone has no other times than those.
    fn quantiles(&self, series: &Series) -> Option<Quantiles> {
        let warm: Vec<f64> = series.iter().filter(|(frame, _)| *frame >= self.warm_up).map(|(_, ms)| *ms).collect();
        Quantiles::of(warm).or_else(|| Quantiles::of(series.iter().map(|(_, ms)| *ms).collect()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Span, SpanFlag};

    fn report(frame: u64, step_ticks: u64) -> FrameReport {
        let span = |label, stage, begin_ticks, end_ticks| Span {
            recording: RecordingId::outside(label),
            stage,
            begin_ticks,
            end_ticks,
            flag: SpanFlag::Ok,
        };
        FrameReport {
            frame,
            wall_ns: 0,
            spans: vec![
                span("step", "sort", 100, 150),
                span("step", "solve", 160, 100 + step_ticks),
                span("draw", "draw_floor", 1_000, 9_000),
            ],
            dropped_spans: 0,
            readbacks: Vec::new(),
            timing: TimingStatus::InsidePasses,
            timestamp_period_ns: 1e6,
        }
    }

    #[test]
    fn percentiles_of_known_values() {
        assert_eq!(Quantiles::of(Vec::new()), None);
        let hundred: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        let quantiles = Quantiles::of(hundred).unwrap();
        assert_eq!((quantiles.median, quantiles.p95), (50.5, 95.0));
        let one = Quantiles::of(vec![3.0]).unwrap();
        assert_eq!((one.median, one.p95), (3.0, 3.0));
    }

    #[test]
    fn a_step_is_its_recordings_spans_with_the_gaps_between() {
        let mut timings = Timings::new(0);
        timings.add(&report(0, 300), RecordingId::outside("step"));
        assert_eq!(timings.step_ms().unwrap().median, 300.0);
        assert_eq!(timings.stage_ms("sort").unwrap().median, 50.0);
        assert_eq!(timings.stage_ms("draw_floor").unwrap().median, 8000.0);
        assert_eq!(timings.stage_ms("absent"), None);
        timings.add(&report(1, 300), RecordingId::outside("step"));
        assert_eq!((timings.total_ms("sort"), timings.total_ms("absent")), (100.0, 0.0));
        let pass = timings.pass("sort", 3);
        assert_eq!((pass.median_ms, pass.dispatches, pass.total_ms), (Some(50.0), 3, Some(100.0)));
        assert_eq!(timings.pass("absent", 1).total_ms, None, "what was not timed took no known time");
    }

    #[test]
    fn the_warm_up_does_not_count() {
        let mut timings = Timings::new(2);
        for (frame, ticks) in [900, 900, 300, 200, 250].into_iter().enumerate() {
            timings.add(&report(frame as u64, ticks), RecordingId::outside("step"));
        }
        let step = timings.step_ms().unwrap();
        assert_eq!((step.median, step.p95), (250.0, 300.0));
        assert_eq!((timings.least_ms("sort"), timings.least_ms("absent")), (Some(50.0), None));
        assert_eq!((timings.frames(), timings.warm_up()), (5, 2));
        assert_eq!([0, 3, 8, 40, 4000].map(warm_up_frames), [0, 0, 2, 10, 10]);
    }
}
