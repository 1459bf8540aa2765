//! How far a capture's times can be believed, counted.

use serde::Serialize;

use crate::FrameRow;

/// The sum of passes may exceed its frame by this share before it is counted: ticks are rounded.
const SUM_SHARE: f64 = 1.001;

/// Counts over the frames of a capture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Trust {
    /// Frames recorded.
    pub frames: u64,
    /// Frames with GPU times.
    pub timed_frames: u64,
    /// Passes with a span.
    pub spans: u64,
    /// Spans that begin and end at the same tick.
    pub zero_spans: u64,
    /// Spans that end before they begin.
    pub negative_spans: u64,
    /// Spans that begin before an earlier one of their frame ended.
    pub overlapping_spans: u64,
    /// Spans behind a gap longer than themselves and a twentieth of their frame.
    pub gap_spans: u64,
    /// Passes that were to be timed and have no span.
    pub dropped_spans: u64,
    /// Frames that gave no report.
    pub dropped_frames: u64,
    /// Frames whose passes sum up to more than the frame itself took.
    pub sums_over_frame: u64,
    /// Messages whose moment was before that of a message already written; their `log_time` was raised to it.
    pub log_times_raised: u64,
    /// Sum of `gpu_ms`.
    pub gpu_ms: f64,
    /// Sum of `pass_sum_ms`.
    pub pass_sum_ms: f64,
}

impl Trust {
    /// Counts a frame.
    pub fn add(&mut self, row: &FrameRow) {
        self.frames += 1;
        self.spans += u64::from(row.spans);
        self.zero_spans += u64::from(row.zero_spans);
        self.negative_spans += u64::from(row.negative_spans);
        self.overlapping_spans += u64::from(row.overlapping_spans);
        self.gap_spans += u64::from(row.gap_spans);
        self.dropped_spans += u64::from(row.dropped_spans);
        self.dropped_frames += row.dropped_frames;
        if let (Some(gpu_ms), Some(sum_ms)) = (row.gpu_ms, row.pass_sum_ms) {
            self.timed_frames += 1;
            self.gpu_ms += gpu_ms;
            self.pass_sum_ms += sum_ms;
            self.sums_over_frame += u64::from(sum_ms > SUM_SHARE * gpu_ms);
        }
    }

    /// Spans that cannot be believed.
    pub fn flagged_spans(&self) -> u64 {
        self.zero_spans + self.negative_spans + self.overlapping_spans + self.gap_spans
    }

    /// Sum of all passes over that of all frames; what is missing to 1 lies between passes. None without
    /// times.
    pub fn pass_share(&self) -> Option<f64> {
        (self.gpu_ms > 0.0).then(|| self.pass_sum_ms / self.gpu_ms)
    }

    /// The counts as they stand in the metadata `trust`.
    pub fn fields(&self) -> Vec<(&'static str, String)> {
        let mut fields: Vec<(&'static str, String)> = self.counts().map(|(key, count)| (key, count.to_string())).into();
        fields.extend(self.pass_share().map(|share| ("pass_share", format!("{share:.4}"))));
        fields
    }

    /// The counts by name.
    pub fn counts(&self) -> [(&'static str, u64); 11] {
        [
            ("frames", self.frames),
            ("timed_frames", self.timed_frames),
            ("spans", self.spans),
            ("zero_spans", self.zero_spans),
            ("negative_spans", self.negative_spans),
            ("overlapping_spans", self.overlapping_spans),
            ("gap_spans", self.gap_spans),
            ("dropped_spans", self.dropped_spans),
            ("dropped_frames", self.dropped_frames),
            ("sums_over_frame", self.sums_over_frame),
            ("log_times_raised", self.log_times_raised),
        ]
    }
}
