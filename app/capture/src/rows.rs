//! The messages of a capture, as they are written and read.

use std::collections::BTreeMap;

use brooklet_gpu::{SpanFlag, TimingStatus};
use serde::{Deserialize, Serialize};

/// `/gpu/frame`: one frame as a whole.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FrameRow {
    /// Frame number, from the engine.
    pub frame: u64,
    /// When it was submitted, seconds since the capture's zero.
    pub wall_s: f64,
    /// First begin to last end on the GPU, ms; absent where the device gave no usable times.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gpu_ms: Option<f64>,
    /// Sum of all passes, ms; differs from `gpu_ms` by the gaps between them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass_sum_ms: Option<f64>,
    /// How the times were taken: `inside_passes`, `pass_per_stage` (each dispatch is a pass of its
    /// own, which costs time itself), `own_passes` (of a host program), `unsupported`, `off`.
    pub timing: String,
    /// Number of timed passes.
    pub spans: u32,
    /// How many of them cannot be believed: the sum of the next four.
    pub flagged_spans: u32,
    /// Spans that begin and end at the same tick.
    pub zero_spans: u32,
    /// Spans that end before they begin.
    pub negative_spans: u32,
    /// Spans that begin before an earlier one of the frame ended.
    pub overlapping_spans: u32,
    /// Spans behind a gap longer than themselves and a twentieth of the frame.
    pub gap_spans: u32,
    /// Passes that were to be timed and have no span.
    pub dropped_spans: u32,
    /// Frames between the one before and this that gave no report.
    pub dropped_frames: u64,
    /// Processor time that capturing took since the previous frame's message, ms.
    pub capture_ms: f64,
}

/// `/gpu/passes`: the time of every stage in one frame.
#[derive(Clone, Debug, PartialEq)]
pub struct PassRow {
    /// Frame number.
    pub frame: u64,
    /// When it was submitted, seconds since the capture's zero.
    pub wall_s: f64,
    /// Stage and its time, ms, dispatches summed, rounded to 1e-6 ms (`/gpu/span` has the ticks). Only
    /// stages that ran in this frame.
    pub stage_ms: BTreeMap<String, f64>,
}

/// The raw ticks of one pass, out of its frame's message on `/gpu/span`.
#[derive(Clone, Debug, PartialEq, Eq)]
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

/// `/gpu/state`: how is computed and drawn, from here on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StateRow {
    /// When, seconds since the capture's zero; the writer fills it in.
    pub wall_s: f64,
    /// What changed, for a person: `precision half: 21.3 ms a frame, budget 16.7 ms`.
    pub event: String,
    /// Name of the scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<String>,
    /// Tier that the device is used as.
    pub tier: String,
    /// Arithmetic inside pairs.
    pub precision: String,
    /// How the fluid is drawn.
    pub surface: String,
    /// Step of the quality ladder, 0 for the best quality.
    pub rung: i32,
    /// What that step lowers.
    pub rung_name: String,
    /// Whether the simulation stands still.
    pub paused: bool,
    /// Number of particles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub particles: Option<u64>,
    /// Drawn pixels over shown pixels, along a side.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub render_scale: Option<f64>,
    /// Substeps of a step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub substeps: Option<u32>,
    /// Solver iterations of a substep.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub iterations: Option<u32>,
}

/// `/device/check`: whether a kernel's variant, or the device in a case, gives the answers that are known.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct CheckRow {
    /// When, seconds since the capture's zero; the writer fills it in.
    pub wall_s: f64,
    /// `case` or `module` (a kernel's variant).
    pub of: String,
    /// Its name.
    pub name: String,
    /// `right`, `wrong`, `skipped` or `not checked`.
    pub verdict: String,
    /// Numbers that were compared.
    pub compared: u64,
    /// The largest difference, relative to a scale of the case's; absent for what is exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference: Option<f64>,
    /// What it may be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// In words: the worst element, what was got and expected, or why it was skipped.
    pub said: String,
}

/// `/device/thermal`: what the system tells of heat, clocks and power; the rest is absent.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ThermalRow {
    /// When, seconds since the capture's zero; the writer fills it in.
    pub wall_s: f64,
    /// Hottest sensor of the processor, °C.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cpu_c: Option<f64>,
    /// Hottest sensor of the GPU, °C.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gpu_c: Option<f64>,
    /// Hottest of all sensors, °C.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hottest_c: Option<f64>,
    /// Mean clock of the processor's cores, MHz.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cpu_mhz: Option<f64>,
    /// Clock of the GPU, MHz.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gpu_mhz: Option<f64>,
    /// What chooses the processor's clock: `performance`, `powersave`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub governor: Option<String>,
    /// `mains` or `battery`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub power_source: Option<String>,
    /// Charge of the battery, percent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub battery_percent: Option<f64>,
    /// Power that the battery gives, W.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub power_w: Option<f64>,
    /// Thermal status by name, where the system has one (Android).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub status: Option<String>,
    /// Thermal headroom forecast, 1 where throttling begins (Android).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub headroom: Option<f64>,
}

impl ThermalRow {
    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        *self == Self { wall_s: self.wall_s, ..Self::default() }
    }
}

/// How grave a line of `/log` is, as `foxglove.Log` numbers it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// For whoever looks for a fault.
    Debug = 1,
    /// For information.
    Info = 2,
    /// Something is not as it should be, and the program goes on.
    Warning = 3,
    /// Something was asked for and cannot be done.
    Error = 4,
    /// The program ends.
    Fatal = 5,
}

/// `/sim/stats`: the caller's named statistics.
#[derive(Clone, Debug, PartialEq)]
pub struct StatsRow {
    /// Frame number.
    pub frame: u64,
    /// When it was submitted, seconds since the capture's zero.
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
        TimingStatus::OwnPasses => "own_passes",
    }
}
