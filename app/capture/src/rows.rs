//! The messages of a capture, as they are written and read.

use std::collections::BTreeMap;

use brooklet_gpu::{SpanFlag, TimingStatus};
use serde::{Deserialize, Serialize};

/// `/gpu/frame`: one frame as a whole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FrameRow {
    /// Frame number, from the engine.
    pub frame: u64,
    /// When it was submitted, seconds since the engine started.
    pub wall_s: f64,
    /// First begin to last end on the GPU, ms; absent where the device gave no usable times.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gpu_ms: Option<f64>,
    /// Sum of all passes, ms; differs from `gpu_ms` by the gaps between them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass_sum_ms: Option<f64>,
    /// How the times were taken: `inside_passes`, `pass_per_stage` (each dispatch is a pass of its
    /// own, which costs time itself), `unsupported`, `off`.
    pub timing: String,
    /// Number of timed passes.
    pub spans: u32,
    /// How many of them were zero, negative, overlapping or behind a gap.
    pub flagged_spans: u32,
    /// Processor time that capturing took since the previous frame's message, ms.
    pub capture_ms: f64,
}

/// `/gpu/passes`: the time of every stage in one frame.
#[derive(Clone, Debug, PartialEq)]
pub struct PassRow {
    /// Frame number.
    pub frame: u64,
    /// When it was submitted, seconds since the engine started.
    pub wall_s: f64,
    /// Stage and its time, ms, dispatches summed. Only stages that ran in this frame.
    pub stage_ms: BTreeMap<String, f64>,
}

/// `/gpu/span`: the raw ticks of one pass.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SpanRow {
    /// Frame number.
    pub frame: u64,
    /// Recording the pass belongs to.
    pub recording: String,
    /// Its stage.
    pub stage: String,
    /// Timestamp at its begin, ticks of the device (`timestamp_period_ns` in the metadata).
    pub begin_ticks: u64,
    /// Timestamp at its end.
    pub end_ticks: u64,
    /// `ok`, `zero`, `negative`, `overlapping` or `gap`.
    pub flag: String,
}

/// `/sim/stats`: the caller's named statistics.
#[derive(Clone, Debug, PartialEq)]
pub struct StatsRow {
    /// Frame number.
    pub frame: u64,
    /// When it was submitted, seconds since the engine started.
    pub wall_s: f64,
    /// Name and value; a value that was not finite is absent (JSON has no such number).
    pub values: BTreeMap<String, f64>,
}

/// How a span's flag is written.
pub(crate) fn flag_name(flag: SpanFlag) -> &'static str {
    match flag {
        SpanFlag::Ok => "ok",
        SpanFlag::Zero => "zero",
        SpanFlag::Negative => "negative",
        SpanFlag::Overlapping => "overlapping",
        SpanFlag::Gap => "gap",
    }
}

/// How the way of timing is written.
pub(crate) fn timing_name(timing: TimingStatus) -> &'static str {
    match timing {
        TimingStatus::Off => "off",
        TimingStatus::Unsupported => "unsupported",
        TimingStatus::PassPerStage => "pass_per_stage",
        TimingStatus::InsidePasses => "inside_passes",
    }
}
