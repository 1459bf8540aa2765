//! The clocks of a capture, and what ties them together.
//!
//! - *Wall clock*: read once, when the capture's clock is zero. Later changes of it (NTP, a user) change
//!   nothing.
//! - *Capture clock*: a monotonic clock from there on, in ns. `log_time` is their sum.
//! - *GPU ticks*: raw. No pass begins before its frame was handed to the GPU, so the frame whose first pass
//!   followed its submission most closely bounds the tick at the capture's zero from above.

use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use brooklet_gpu::FrameReport;

/// The capture clock: one zero, on the wall clock and on the monotonic one.
#[derive(Clone, Copy, Debug)]
pub struct CaptureClock {
    zero: Instant,
    start: SystemTime,
}

impl CaptureClock {
    /// A clock that is zero now.
    pub fn new() -> Self {
        Self::of(Instant::now())
    }

    /// A clock that was zero at `zero`, as when an engine was made whose `wall_ns` count from there.
    pub fn of(zero: Instant) -> Self {
        let elapsed = zero.elapsed();
        let start = SystemTime::now().checked_sub(elapsed).unwrap_or(UNIX_EPOCH);
        Self { zero, start }
    }

    /// The wall clock at zero.
    pub fn start(&self) -> SystemTime {
        self.start
    }

    /// The moment of zero.
    pub fn zero(&self) -> Instant {
        self.zero
    }

    /// Nanoseconds since zero.
    pub fn ns(&self) -> u64 {
        self.ns_at(Instant::now())
    }

    /// Nanoseconds from zero to `moment`; 0 before it.
    pub fn ns_at(&self, moment: Instant) -> u64 {
        moment.saturating_duration_since(self.zero).as_nanos() as u64
    }
}

impl Default for CaptureClock {
    fn default() -> Self {
        Self::new()
    }
}

/// What is said of the clocks in every capture, as metadata `clocks`.
pub(crate) fn statement(start_ns: u64) -> [(&'static str, String); 5] {
    let text = |text: &str| text.to_string();
    [
        ("zero_unix_ns", start_ns.to_string()),
        (
            "log_time",
            text(
                "Unix ns of the event: the wall clock at zero plus a monotonic clock since; an event before one \
                 already written gets that one's, counted in `trust` as log_times_raised",
            ),
        ),
        ("publish_time", text("Unix ns of the event on the same clock, never raised")),
        ("wall_s", text("seconds since zero; of a frame, when it was handed to the GPU")),
        (
            "ticks",
            text(
                "GPU timestamps as the device wrote them; metadata `ticks`, written at the end, ties them to log_time",
            ),
        ),
    ]
}

/// Ties ticks to the capture clock, frame by frame.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TickTie {
    base: Option<Base>,
    frames: u64,
}

#[derive(Clone, Copy, Debug)]
struct Base {
    ticks: u64,
    wall_ns: u64,
    period_ns: f64,
    /// Of all frames: first begin minus submission, both since the base frame's, ns.
    least_ns: f64,
    most_ns: f64,
}

impl TickTie {
    pub fn add(&mut self, report: &FrameReport) {
        let Some(first) = report.spans.first() else { return };
        let base = self.base.get_or_insert(Base {
            ticks: first.begin_ticks,
            wall_ns: report.wall_ns,
            period_ns: report.timestamp_period_ns,
            least_ns: 0.0,
            most_ns: 0.0,
        });
        // Differences, which a double holds exactly where the ticks themselves are beyond 2^53.
        let ticks = first.begin_ticks.wrapping_sub(base.ticks) as i64 as f64;
        let wall_ns = report.wall_ns.wrapping_sub(base.wall_ns) as i64 as f64;
        let delay_ns = ticks * base.period_ns - wall_ns;
        base.least_ns = base.least_ns.min(delay_ns);
        base.most_ns = base.most_ns.max(delay_ns);
        self.frames += 1;
    }

    /// The metadata `ticks`; none without ticks.
    pub fn fields(&self, start_ns: u64) -> Option<[(&'static str, String); 6]> {
        let base = self.base?;
        let at_ns = start_ns as i128 + i128::from(base.wall_ns) - base.least_ns.round() as i128;
        Some([
            ("timestamp_period_ns", base.period_ns.to_string()),
            ("at_ticks", base.ticks.to_string()),
            ("at_unix_ns", at_ns.to_string()),
            ("frames", self.frames.to_string()),
            ("delay_spread_ms", format!("{:.6}", (base.most_ns - base.least_ns) * 1e-6)),
            (
                "how",
                "at_unix_ns is the earliest Unix time of the tick at_ticks with which no frame's first pass begins \
                 before its submission; it is late by no more than the shortest way from submission to begin"
                    .to_string(),
            ),
        ])
    }
}

pub(crate) fn epoch_ns(moment: SystemTime) -> u64 {
    moment.duration_since(UNIX_EPOCH).unwrap_or(Duration::ZERO).as_nanos() as u64
}

/// Gives each event its `log_time`: never before that of the event written last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LogClock {
    pub start_ns: u64,
    last_ns: u64,
    pub raised: u64,
}

impl LogClock {
    pub fn new(start: SystemTime) -> Self {
        Self { start_ns: epoch_ns(start), last_ns: 0, raised: 0 }
    }

    /// `log_time` and `publish_time` of an event at `wall_ns` of the capture clock.
    pub fn times(&mut self, wall_ns: u64) -> (u64, u64) {
        let event_ns = self.start_ns.saturating_add(wall_ns);
        self.raised += u64::from(event_ns < self.last_ns);
        self.last_ns = self.last_ns.max(event_ns);
        (self.last_ns, event_ns)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_gpu::{RecordingId, Span, SpanFlag, TimingStatus};

    fn report(wall_ns: u64, begin_ticks: u64) -> FrameReport {
        let span = Span {
            recording: RecordingId::outside("step"),
            stage: "a",
            begin_ticks,
            end_ticks: begin_ticks + 5,
            flag: SpanFlag::Ok,
        };
        FrameReport {
            frame: 0,
            wall_ns,
            spans: vec![span],
            dropped_spans: 0,
            readbacks: Vec::new(),
            timing: TimingStatus::InsidePasses,
            timestamp_period_ns: 2.0,
        }
    }

    #[test]
    fn the_frame_that_began_soonest_ties_the_ticks() {
        let mut tie = TickTie::default();
        assert!(tie.fields(0).is_none());
        // Ticks of 2 ns that were 1 << 60 at the capture's zero; ways of 300, 100 and 900 ns.
        for (wall_ns, way_ns) in [(1_000, 300), (21_000, 100), (41_000, 900)] {
            tie.add(&report(wall_ns, (1 << 60) + (wall_ns + way_ns) / 2));
        }
        let fields = std::collections::BTreeMap::from(tie.fields(1_000_000).unwrap());
        let at_ticks: u64 = fields["at_ticks"].parse().unwrap();
        let at_ns: u64 = fields["at_unix_ns"].parse().unwrap();
        let true_ns = 1_000_000 + (at_ticks - (1 << 60)) * 2;
        assert_eq!(true_ns - at_ns, 100, "off by the shortest way alone");
        assert_eq!((&*fields["frames"], &*fields["delay_spread_ms"]), ("3", "0.000800"));
    }

    #[test]
    fn log_time_never_goes_back() {
        let mut clock = LogClock::new(UNIX_EPOCH + Duration::from_nanos(100));
        let times = [5, 9, 7, 9, 12].map(|wall_ns| clock.times(wall_ns));
        assert_eq!(times, [(105, 105), (109, 109), (109, 107), (109, 109), (112, 112)]);
        assert_eq!(clock.raised, 1);
    }
}
