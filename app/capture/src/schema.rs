//! Topics and their JSON Schemas.
//!
//! Fields are flat and primitive, because plotting tools draw those without any set-up; only the raw ticks
//! of a frame's passes are lists.

use serde_json::{Map, Value, json};

/// One message per frame.
pub const FRAME_TOPIC: &str = "/gpu/frame";
/// One message per frame: the time of each stage.
pub const PASSES_TOPIC: &str = "/gpu/passes";
/// One message per frame: raw ticks of each pass.
pub const SPAN_TOPIC: &str = "/gpu/span";
/// One message per change: how is computed and drawn.
pub const STATE_TOPIC: &str = "/gpu/state";
/// One message per measurement: the caller's statistics.
pub const STATS_TOPIC: &str = "/sim/stats";
/// Temperatures, clocks and power of the machine, about once a second.
pub const THERMAL_TOPIC: &str = "/device/thermal";
/// Whether the device gives the answers that are known: one message a case, and one a kernel's variant.
pub const CHECK_TOPIC: &str = "/device/check";
/// Some of the particles (`foxglove.PointCloud`).
pub const PARTICLES_TOPIC: &str = "/sim/particles";
/// What is seen (`foxglove.CompressedImage`).
pub const IMAGE_TOPIC: &str = "/view/image";
/// What happened (`foxglove.Log`).
pub const LOG_TOPIC: &str = "/log";

/// Every topic, in the order of the documentation.
pub const TOPICS: [&str; 10] = [
    FRAME_TOPIC,
    PASSES_TOPIC,
    SPAN_TOPIC,
    STATE_TOPIC,
    STATS_TOPIC,
    THERMAL_TOPIC,
    CHECK_TOPIC,
    PARTICLES_TOPIC,
    IMAGE_TOPIC,
    LOG_TOPIC,
];

/// Version of what the topics hold, in the metadata of each channel under [`FORMAT_KEY`]. Captures before
/// version 2 had none.
pub const FORMAT_VERSION: &str = "2";
/// Where a channel has its version.
pub const FORMAT_KEY: &str = "format_version";

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

impl<N: AsRef<str>> From<(N, &str, &str)> for StatField {
    fn from((name, unit, description): (N, &str, &str)) -> Self {
        Self::new(name.as_ref(), unit, description)
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

fn list(of: &str, description: &str) -> Value {
    json!({ "type": "array", "items": { "type": of }, "description": description })
}

fn fields<const N: usize>(fields: [(&str, Value); N]) -> Map<String, Value> {
    fields.into_iter().map(|(key, value)| (key.into(), value)).collect()
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
    fields([
        ("frame", integer("Frame number")),
        ("wall_s", number("s", "When the frame was submitted, since the capture's zero")),
    ])
}

/// Schema of `/gpu/frame`.
pub fn frame_schema() -> Value {
    let mut all = clock();
    all.extend(fields([
        ("gpu_ms", number("ms", "First begin to last end on the GPU; absent without usable times")),
        ("pass_sum_ms", number("ms", "Sum of all passes; the rest of gpu_ms is gaps between them")),
        (
            "timing",
            json!({
                "type": "string",
                "enum": ["off", "unsupported", "pass_per_stage", "inside_passes", "own_passes"],
                "description": "How the times were taken; pass_per_stage costs time itself",
            }),
        ),
        ("spans", integer("Number of timed passes")),
        ("flagged_spans", integer("How many of them cannot be believed: the sum of the next four")),
        ("zero_spans", integer("Spans that begin and end at the same tick")),
        ("negative_spans", integer("Spans that end before they begin")),
        ("overlapping_spans", integer("Spans that begin before an earlier one of the frame ended")),
        ("gap_spans", integer("Spans behind a gap longer than themselves and a twentieth of the frame")),
        ("dropped_spans", integer("Passes that were to be timed and have no span")),
        ("dropped_frames", integer("Frames between the one before and this that gave no report")),
        ("capture_ms", number("ms", "Processor time of capturing since the previous frame's message")),
    ]));
    let required = [
        "frame",
        "wall_s",
        "timing",
        "spans",
        "flagged_spans",
        "zero_spans",
        "negative_spans",
        "overlapping_spans",
        "gap_spans",
        "dropped_spans",
        "dropped_frames",
        "capture_ms",
    ];
    object("brooklet.Frame", &required, all)
}

/// Key of a stage in `/gpu/passes`.
pub(crate) fn stage_key(stage: &str) -> String {
    format!("{stage}_ms")
}

/// Schema of `/gpu/passes` for these stages. A stage that does not run in a frame (a picture is not drawn
/// in each) is absent from that frame's message.
pub fn passes_schema<'s>(stages: impl IntoIterator<Item = &'s str>) -> Value {
    let mut all = clock();
    for stage in stages {
        all.insert(stage_key(stage), number("ms", &format!("GPU time of {stage}, all its dispatches of the frame")));
    }
    object("brooklet.Passes", &["frame", "wall_s"], all)
}

/// Schema of `/gpu/span`. Lists have one entry for each pass of the frame, in the order of submission.
pub fn span_schema() -> Value {
    let all = fields([
        ("frame", integer("Frame number")),
        ("sequence", integer("Which sequence of passes the frame ran")),
        (
            "passes",
            list(
                "string",
                "The sequence's passes as recording/stage; with the first message of each sequence in a chunk",
            ),
        ),
        ("first_ticks", integer("Timestamp at the first pass's begin, in the device's ticks")),
        ("begin_ticks", list("integer", "Each pass's begin, in ticks since first_ticks")),
        ("ticks", list("integer", "Each pass's end, in ticks since its begin")),
        (
            "flags",
            json!({
                "type": "array",
                "items": { "type": "string", "enum": ["ok", "zero", "negative", "overlapping", "gap"] },
                "description": "What is wrong with the ticks; absent if nothing is with any",
            }),
        ),
    ]);
    object("brooklet.Spans", &["frame", "sequence", "first_ticks", "begin_ticks", "ticks"], all)
}

/// Schema of `/gpu/state`.
pub fn state_schema() -> Value {
    let all = fields([
        ("wall_s", number("s", "When it was so, since the capture's zero")),
        ("event", text("What changed, for a person")),
        ("scene", text("Name of the scene")),
        ("tier", text("Tier that the device is used as")),
        ("precision", text("Arithmetic inside pairs: full, relaxed or half")),
        ("surface", text("How the fluid is drawn")),
        ("rung", integer("Step of the quality ladder, 0 for the best quality")),
        ("rung_name", text("What that step lowers")),
        ("paused", json!({ "type": "boolean", "description": "Whether the simulation stands still" })),
        ("particles", integer("Number of particles")),
        ("render_scale", number("1", "Drawn pixels over shown pixels, along a side")),
        ("substeps", integer("Substeps of a step")),
        ("iterations", integer("Solver iterations of a substep")),
    ]);
    let required = ["wall_s", "event", "tier", "precision", "surface", "rung", "rung_name", "paused"];
    object("brooklet.State", &required, all)
}

/// Schema of `/device/thermal`: what the system does not tell is absent.
pub fn thermal_schema() -> Value {
    let all = fields([
        ("wall_s", number("s", "When it was read, since the capture's zero")),
        ("cpu_c", number("degC", "Hottest sensor of the processor")),
        ("gpu_c", number("degC", "Hottest sensor of the GPU")),
        ("hottest_c", number("degC", "Hottest of all sensors")),
        ("cpu_mhz", number("MHz", "Mean clock of the processor's cores")),
        ("gpu_mhz", number("MHz", "Clock of the GPU")),
        ("governor", text("What chooses the processor's clock")),
        ("power_source", text("mains or battery")),
        ("battery_percent", number("%", "Charge of the battery")),
        ("power_w", number("W", "Power that the battery gives")),
        ("status", text("Thermal status by name, where the system has one")),
        ("headroom", number("1", "Thermal headroom forecast, 1 where throttling begins")),
    ]);
    object("brooklet.Thermal", &["wall_s"], all)
}

/// Schema of `/device/check`.
pub fn check_schema() -> Value {
    let all = fields([
        ("wall_s", number("s", "When it was known, since the capture's zero")),
        ("of", text("case or module: a kernel's variant")),
        ("name", text("Its name")),
        ("verdict", text("right, wrong, skipped or not checked")),
        ("compared", integer("Numbers that were compared")),
        ("difference", number("1", "The largest difference, relative to a scale of the case's")),
        ("tolerance", number("1", "What it may be")),
        ("said", text("The worst element, what was got and expected, or why it was skipped")),
    ]);
    object("brooklet.Check", &["wall_s", "of", "name", "verdict", "compared", "said"], all)
}

/// Schema of `/sim/stats` for the caller's fields. JSON has no NaN: a value that is not finite is
/// absent from its message.
pub fn stats_schema(stats: &[StatField]) -> Value {
    let mut all = clock();
    for stat in stats {
        all.insert(stat.name.clone(), number(&stat.unit, &stat.description));
    }
    object("brooklet.Stats", &["frame", "wall_s"], all)
}

/// Schema of `/log`, as Foxglove's tools know it by its name.
pub fn log_schema() -> Value {
    let time = json!({
        "type": "object",
        "title": "time",
        "properties": { "sec": integer("Unix time, whole seconds"), "nsec": integer("Nanoseconds beyond them") },
        "required": ["sec", "nsec"],
        "description": "When it happened",
    });
    let level = json!({
        "title": "foxglove.LogLevel",
        "oneOf": [
            { "title": "UNKNOWN", "const": 0 },
            { "title": "DEBUG", "const": 1 },
            { "title": "INFO", "const": 2 },
            { "title": "WARNING", "const": 3 },
            { "title": "ERROR", "const": 4 },
            { "title": "FATAL", "const": 5 },
        ],
        "description": "How grave it is",
    });
    let all = fields([
        ("timestamp", time),
        ("level", level),
        ("message", text("What happened")),
        ("name", text("Program")),
        ("file", text("Empty")),
        ("line", integer("0")),
    ]);
    object("foxglove.Log", &["timestamp", "level", "message", "name", "file", "line"], all)
}
