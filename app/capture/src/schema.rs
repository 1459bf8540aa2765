//! Topics and their JSON Schemas.
//!
//! Fields are flat and primitive, because plotting tools draw those without any set-up.

use serde_json::{Map, Value, json};

/// One message per frame.
pub const FRAME_TOPIC: &str = "/gpu/frame";
/// One message per frame: the time of each stage.
pub const PASSES_TOPIC: &str = "/gpu/passes";
/// One message per pass: raw ticks.
pub const SPAN_TOPIC: &str = "/gpu/span";
/// One message per measurement: the caller's statistics.
pub const STATS_TOPIC: &str = "/sim/stats";

/// A statistic that the caller will give, described once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StatField {
    /// Its key in `/sim/stats`: `max_speed_m_s`.
    pub name: String,
    /// Its unit in SI notation, `1` for a ratio or a count.
    pub unit: String,
    /// What it says, in a sentence.
    pub description: String,
}

impl StatField {
    /// A field from its three texts.
    pub fn new(name: &str, unit: &str, description: &str) -> Self {
        Self { name: name.into(), unit: unit.into(), description: description.into() }
    }
}

fn number(unit: &str, description: &str) -> Value {
    json!({ "type": "number", "unit": unit, "description": format!("{description} [{unit}]") })
}

fn integer(description: &str) -> Value {
    json!({ "type": "integer", "description": description })
}

fn text(description: &str) -> Value {
    json!({ "type": "string", "description": description })
}

fn object(title: &str, required: &[&str], properties: Map<String, Value>) -> Value {
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": title,
        "type": "object",
        "properties": properties,
        "required": required,
    })
}

fn clock() -> Map<String, Value> {
    Map::from_iter([
        ("frame".into(), integer("Frame number")),
        ("wall_s".into(), number("s", "When the frame was submitted, since the engine started")),
    ])
}

/// Schema of `/gpu/frame`.
pub fn frame_schema() -> Value {
    let mut fields = clock();
    fields.extend([
        ("gpu_ms".into(), number("ms", "First begin to last end on the GPU; absent without usable times")),
        ("pass_sum_ms".into(), number("ms", "Sum of all passes; the rest of gpu_ms is gaps between them")),
        (
            "timing".into(),
            json!({
                "type": "string",
                "enum": ["off", "unsupported", "pass_per_stage", "inside_passes"],
                "description": "How the times were taken; pass_per_stage costs time itself",
            }),
        ),
        ("spans".into(), integer("Number of timed passes")),
        ("flagged_spans".into(), integer("How many of them were zero, negative, overlapping or behind a gap")),
        ("capture_ms".into(), number("ms", "Processor time of capturing since the previous frame's message")),
    ]);
    object("brooklet.Frame", &["frame", "wall_s", "timing", "spans", "flagged_spans", "capture_ms"], fields)
}

/// Key of a stage in `/gpu/passes`.
pub(crate) fn stage_key(stage: &str) -> String {
    format!("{stage}_ms")
}

/// Schema of `/gpu/passes` for a plan's stages. A stage that does not run in a frame (a picture
/// is not drawn in each) is absent from that frame's message.
pub fn passes_schema(stages: &[String]) -> Value {
    let mut fields = clock();
    for stage in stages {
        fields.insert(stage_key(stage), number("ms", &format!("GPU time of {stage}, all its dispatches of the frame")));
    }
    object("brooklet.Passes", &["frame", "wall_s"], fields)
}

/// Schema of `/gpu/span`.
pub fn span_schema() -> Value {
    let fields = Map::from_iter([
        ("frame".into(), integer("Frame number")),
        ("recording".into(), text("Recording the pass belongs to")),
        ("stage".into(), text("Stage of the pass")),
        ("begin_ticks".into(), integer("Timestamp at the begin, in the device's ticks")),
        ("end_ticks".into(), integer("Timestamp at the end, in the device's ticks")),
        (
            "flag".into(),
            json!({
                "type": "string",
                "enum": ["ok", "zero", "negative", "overlapping", "gap"],
                "description": "What is wrong with the ticks, if anything",
            }),
        ),
    ]);
    object("brooklet.Span", &["frame", "recording", "stage", "begin_ticks", "end_ticks", "flag"], fields)
}

/// Schema of `/sim/stats` for the caller's fields. JSON has no NaN: a value that is not finite is
/// absent from its message.
pub fn stats_schema(stats: &[StatField]) -> Value {
    let mut fields = clock();
    for stat in stats {
        fields.insert(stat.name.clone(), number(&stat.unit, &stat.description));
    }
    object("brooklet.Stats", &["frame", "wall_s"], fields)
}
