//! GPU times as plain data: raw ticks, flags for those that cannot be right, and sums.

use crate::recording::RecordingId;
use brooklet_kernels::{Buffer, ResourceId};
use bytemuck::Pod;

/// How GPU times are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TimingStatus {
    /// Not asked for.
    Off,
    /// The device has no timestamps.
    Unsupported,
    /// Each dispatch is a compute pass of its own, because the device cannot write a timestamp
    /// inside one: the passes themselves cost time that an untimed run does not have.
    PassPerStage,
    /// A timestamp between any two dispatches of a pass.
    InsidePasses,
    /// A program's own passes, each from its begin to its end ([`crate::PassTimer`]).
    OwnPasses,
}

impl TimingStatus {
    /// Whether there are spans at all.
    pub fn is_measured(self) -> bool {
        matches!(self, Self::PassPerStage | Self::InsidePasses | Self::OwnPasses)
    }

    /// As summaries have it: `off`, `inside_passes`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Unsupported => "unsupported",
            Self::PassPerStage => "pass_per_stage",
            Self::InsidePasses => "inside_passes",
            Self::OwnPasses => "own_passes",
        }
    }
}

/// Whether a span can be believed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpanFlag {
    /// Nothing speaks against it.
    Ok,
    /// It begins and ends at the same tick: shorter than the clock's period, or not measured.
    Zero,
    /// It ends before it begins: the counter wrapped, or the driver is wrong.
    Negative,
    /// It begins before an earlier span of its frame ended, so both count the same time.
    Overlapping,
    /// More time lies between it and the span before than it took itself, and more than a
    /// twentieth of the frame: clears and copies, or a begin that the driver wrote too late. (Mesa's
    /// CPU driver 22.3.6, once it has drawn, writes a pass's first tick behind its first dispatch.)
    Gap,
}

/// A gap is flagged from this part of its frame on.
const GAP_SHARE: u64 = 20;

impl SpanFlag {
    /// The flag of a span, `previous_end` being the latest end of the frame's earlier spans, and
    /// `frame_ticks` the frame's length.
    pub fn of(begin_ticks: u64, end_ticks: u64, previous_end: Option<u64>, frame_ticks: u64) -> Self {
        let gap = previous_end.map_or(0, |end| begin_ticks.saturating_sub(end));
        if end_ticks < begin_ticks {
            Self::Negative
        } else if previous_end.is_some_and(|end| begin_ticks < end) {
            Self::Overlapping
        } else if end_ticks == begin_ticks {
            Self::Zero
        } else if gap > end_ticks - begin_ticks && gap > frame_ticks / GAP_SHARE {
            Self::Gap
        } else {
            Self::Ok
        }
    }
}

/// One timed dispatch or render pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// Recording it belongs to.
    pub recording: RecordingId,
    /// Its stage; of a render pass without inner timestamps, the first draw's.
    pub stage: &'static str,
    /// Tick when everything before it was done, as the device wrote it.
    pub begin_ticks: u64,
    /// Tick when it was done, as the device wrote it.
    pub end_ticks: u64,
    /// Whether that can be believed.
    pub flag: SpanFlag,
}

impl Span {
    /// Its length in ticks; 0 if negative.
    pub fn ticks(&self) -> u64 {
        self.end_ticks.saturating_sub(self.begin_ticks)
    }
}

/// What is known of a frame once the GPU is done with it.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameReport {
    /// Its number, as `Engine::run` gave it.
    pub frame: u64,
    /// When it was handed to the GPU, in nanoseconds since the engine was made.
    pub wall_ns: u64,
    /// Its spans, in the order in which they ran.
    pub spans: Vec<Span>,
    /// Passes that were to be timed and have no span: no query was left, or their ticks did not come.
    pub dropped_spans: u32,
    /// The buffers and textures that were asked for, as they were at the frame's end; a texture's
    /// rows from the top, without padding.
    pub readbacks: Vec<(ResourceId, Vec<u8>)>,
    /// How the spans were taken.
    pub timing: TimingStatus,
    /// Nanoseconds a tick lasts.
    pub timestamp_period_ns: f64,
}

impl FrameReport {
    /// What came back of a buffer or texture, if it was asked for.
    pub fn readback(&self, id: ResourceId) -> Option<&[u8]> {
        self.readbacks.iter().find(|(back, _)| *back == id).map(|(_, bytes)| bytes.as_slice())
    }

    /// The first element of a buffer that came back.
    pub fn first<T: Pod>(&self, buffer: &Buffer<T>) -> Option<T> {
        let bytes = self.readback(buffer.id)?.get(..size_of::<T>())?;
        bytemuck::try_pod_read_unaligned(bytes).ok()
    }

    /// Milliseconds and number of spans of each stage, in order of their first span. Negative
    /// spans count as 0.
    pub fn stage_ms(&self) -> Vec<(&'static str, f64, u32)> {
        let mut stages: Vec<(&'static str, f64, u32)> = Vec::new();
        for span in &self.spans {
            let ms = self.ms(span.ticks());
            match stages.iter_mut().find(|(stage, ..)| *stage == span.stage) {
                Some((_, sum, count)) => {
                    *sum += ms;
                    *count += 1;
                }
                None => stages.push((span.stage, ms, 1)),
            }
        }
        stages
    }

    /// Milliseconds from the first span's begin to the last span's end, what lies between spans
    /// (clears, copies, barriers) included; `None` if nothing was measured or the ticks run back.
    pub fn gpu_ms(&self) -> Option<f64> {
        let begin = self.spans.iter().map(|span| span.begin_ticks).min()?;
        let end = self.spans.iter().map(|span| span.end_ticks).max()?;
        (end > begin).then(|| self.ms(end - begin))
    }

    /// Number of spans that are flagged.
    pub fn flagged(&self) -> usize {
        self.spans.iter().filter(|span| span.flag != SpanFlag::Ok).count()
    }

    /// Takes the spans of another report of the same frame, as of a host program's own passes that ran
    /// behind (or before) an engine's on the same device, and flags all of them anew as one sequence. Which
    /// report's come first is told by their first ticks. The other's ticks must be of the same clock: spans
    /// of another tick length cannot be compared, and are counted as dropped.
    pub fn append(&mut self, other: FrameReport) {
        self.dropped_spans += other.dropped_spans;
        self.readbacks.extend(other.readbacks);
        if other.spans.is_empty() {
            return;
        }
        if self.spans.is_empty() {
            self.timing = other.timing;
            self.timestamp_period_ns = other.timestamp_period_ns;
        } else if self.timestamp_period_ns != other.timestamp_period_ns {
            self.dropped_spans += other.spans.len() as u32;
            return;
        }
        let comes_first = match (other.spans.first(), self.spans.first()) {
            (Some(others), Some(own)) => others.begin_ticks < own.begin_ticks,
            _ => false,
        };
        let at = if comes_first { 0 } else { self.spans.len() };
        self.spans.splice(at..at, other.spans);
        flag(&mut self.spans);
    }

    fn ms(&self, ticks: u64) -> f64 {
        ticks as f64 * self.timestamp_period_ns * 1e-6
    }
}

/// A span before its ticks are known: which ticks of the frame are its own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanSlot {
    pub recording: RecordingId,
    pub stage: &'static str,
    pub begin: u32,
    pub end: u32,
}

/// Puts the ticks to their spans and flags them.
pub(crate) fn spans(slots: &[SpanSlot], ticks: &[u64]) -> Vec<Span> {
    let with_ticks = slots.iter().filter_map(|slot| {
        Some(Span {
            recording: slot.recording,
            stage: slot.stage,
            begin_ticks: *ticks.get(slot.begin as usize)?,
            end_ticks: *ticks.get(slot.end as usize)?,
            flag: SpanFlag::Ok,
        })
    });
    let mut spans: Vec<Span> = with_ticks.collect();
    flag(&mut spans);
    spans
}

/// Flags a frame's spans, which are in the order in which they were submitted.
fn flag(spans: &mut [Span]) {
    let written = || spans.iter().flat_map(|span| [span.begin_ticks, span.end_ticks]);
    let frame_ticks = written().max().zip(written().min()).map_or(0, |(last, first)| last - first);
    let mut previous_end: Option<u64> = None;
    for span in spans {
        span.flag = SpanFlag::of(span.begin_ticks, span.end_ticks, previous_end, frame_ticks);
        previous_end = previous_end.max(Some(span.end_ticks));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slot(stage: &'static str, begin: u32, end: u32) -> SpanSlot {
        SpanSlot { recording: RecordingId::outside("step"), stage, begin, end }
    }

    fn report(spans: Vec<Span>) -> FrameReport {
        FrameReport {
            frame: 0,
            wall_ns: 0,
            spans,
            dropped_spans: 0,
            readbacks: Vec::new(),
            timing: TimingStatus::InsidePasses,
            timestamp_period_ns: 2.0,
        }
    }

    #[test]
    fn each_lie_has_its_flag() {
        let slots = [
            slot("ok", 0, 1),
            slot("zero", 1, 2),
            slot("negative", 2, 3),
            slot("overlapping", 4, 5),
            slot("after_all", 5, 6),
            slot("gap", 7, 8),
        ];
        let flags: Vec<_> =
            spans(&slots, &[100, 200, 200, 150, 199, 300, 301, 380, 400]).iter().map(|span| span.flag).collect();
        use SpanFlag::*;
        assert_eq!(flags, [Ok, Zero, Negative, Overlapping, Ok, Gap]);
    }

    #[test]
    fn missing_ticks_give_no_span() {
        assert_eq!(spans(&[slot("a", 0, 1), slot("b", 1, 2)], &[5, 6]).len(), 1);
    }

    #[test]
    fn stages_are_summed_and_the_frame_spans_the_gaps() {
        let slots = [slot("a", 0, 1), slot("b", 2, 3), slot("a", 3, 4)];
        let report = report(spans(&slots, &[1_000, 2_000, 2_400, 2_900, 4_400]));
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        let stages = report.stage_ms();
        assert_eq!(stages.len(), 2);
        assert!(stages[0].0 == "a" && stages[0].2 == 2 && near(stages[0].1, 5e-3));
        assert!(stages[1].0 == "b" && stages[1].2 == 1 && near(stages[1].1, 1e-3));
        assert!(report.gpu_ms().is_some_and(|ms| near(ms, 6.8e-3)));
        assert_eq!(report.flagged(), 0);
    }

    #[test]
    fn nothing_measured_is_not_zero_time() {
        assert_eq!(report(Vec::new()).gpu_ms(), None);
        let stopped_clock = report(spans(&[slot("a", 0, 1)], &[0, 0]));
        assert_eq!(stopped_clock.gpu_ms(), None);
        assert_eq!(stopped_clock.flagged(), 1);
    }
    #[test]
    fn two_reports_of_a_frame_are_one_sequence() {
        let mut engine = report(spans(&[slot("solve", 0, 1), slot("draw", 1, 2)], &[1_000, 2_000, 3_000]));
        let overlay = report(spans(&[slot("overlay", 0, 1)], &[2_900, 3_400]));
        let before = report(spans(&[slot("upload", 0, 1)], &[900, 1_000]));
        engine.append(overlay);
        engine.append(before);
        let stages: Vec<_> = engine.spans.iter().map(|span| (span.stage, span.flag)).collect();
        use SpanFlag::*;
        assert_eq!(stages, [("upload", Ok), ("solve", Ok), ("draw", Ok), ("overlay", Overlapping)]);
        assert!(engine.gpu_ms().is_some_and(|ms| (ms - 5e-3).abs() < 1e-12));

        let mut other_clock = report(spans(&[slot("overlay", 0, 1)], &[1, 2]));
        other_clock.timestamp_period_ns = 52.0;
        engine.append(other_clock);
        assert_eq!((engine.spans.len(), engine.dropped_spans), (4, 1));

        let mut untimed = report(Vec::new());
        untimed.timing = TimingStatus::Off;
        untimed.append(report(spans(&[slot("overlay", 0, 1)], &[1, 2])));
        assert_eq!((untimed.spans.len(), untimed.timing), (1, TimingStatus::InsidePasses));
    }
}
