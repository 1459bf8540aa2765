//! A whole capture in memory, also one that was cut off or damaged.

use std::{
    collections::BTreeMap,
    fs::File,
    io::{Read, Seek},
    path::Path,
};

use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::{
    CHECK_TOPIC, CaptureError, CheckRow, FRAME_TOPIC, FrameRow, PASSES_TOPIC, PassRow, SPAN_TOPIC, STATE_TOPIC,
    STATS_TOPIC, SpanRow, StatField, StateRow, StatsRow, THERMAL_TOPIC, ThermalRow,
    spans::SpanReader,
    stream::{Channel, Ending, Item, Message, message_problem, read},
};

/// A whole file that was recorded with the run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attachment {
    /// Its name: `dam-break.toml`.
    pub name: String,
    /// Its media type.
    pub media_type: String,
    /// Its content.
    pub data: Vec<u8>,
}

/// What a capture holds but pictures, points and the log, each list in the order of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Capture {
    /// `/gpu/frame`.
    pub frames: Vec<FrameRow>,
    /// `/gpu/passes`.
    pub passes: Vec<PassRow>,
    /// `/gpu/span`, one row a pass.
    pub spans: Vec<SpanRow>,
    /// `/gpu/state`.
    pub states: Vec<StateRow>,
    /// `/device/thermal`.
    pub thermal: Vec<ThermalRow>,
    /// `/device/check`.
    pub checks: Vec<CheckRow>,
    /// `/sim/stats`.
    pub stats: Vec<StatsRow>,
    /// The stages that are declared, whether or not they ran.
    pub stages: Vec<String>,
    /// The named statistics, from the schema of `/sim/stats`.
    pub stat_fields: Vec<StatField>,
    /// Metadata records by name: `device`, `limits`, `build` and whatever the program added.
    pub metadata: BTreeMap<String, BTreeMap<String, String>>,
    /// Attached files.
    pub attachments: Vec<Attachment>,
    /// Whether the file has its proper end and is whole. When not, this is every whole chunk of it.
    pub complete: bool,
    /// How the file ended, in numbers.
    pub ending: Ending,
}

impl Capture {
    /// Reads the file `path`.
    ///
    /// A file that was cut off or damaged is no error: every whole chunk is returned, with
    /// [`Capture::complete`] false.
    pub fn open(path: &Path) -> Result<Self, CaptureError> {
        let name = path.display().to_string();
        let io = |action, source| CaptureError::Io { name: name.clone(), action, source };
        let file = File::open(path).map_err(|e| io("open", e))?;
        let length = file.metadata().map_err(|e| io("open", e))?.len();
        Self::read(file, length, &name)
    }

    /// Reads a capture of `length` bytes from `from`; `name` is what errors call it.
    pub fn read(from: impl Read + Seek, length: u64, name: &str) -> Result<Self, CaptureError> {
        let mut reading =
            Rows { name, capture: Self::default(), sequences: SpanReader::default(), seen: BTreeMap::new() };
        let ending = read(from, length, name, &mut |item| match item {
            Item::Channel(channel) => reading.describe(channel),
            Item::Message(message) => reading.message(message),
            Item::Metadata(name, fields) => {
                reading.capture.metadata.insert(name.into(), fields.clone());
                Ok(())
            }
            Item::Attachment(attachment) => {
                reading.capture.attachments.push(attachment.clone());
                Ok(())
            }
            Item::ChunkEnd => Ok(()),
        })?;
        Ok(Self { complete: ending.complete, ending, ..reading.capture })
    }

    /// Times of one stage over the run, ms, in order of the frames it ran in.
    pub fn stage_ms(&self, stage: &str) -> Vec<f64> {
        self.passes.iter().filter_map(|row| row.stage_ms.get(stage).copied()).collect()
    }
}

/// Stages of a channel of `/gpu/passes`.
pub(crate) fn stages_of(schema: &Map<String, Value>) -> impl Iterator<Item = &str> {
    schema.keys().filter(|key| *key != "frame" && *key != "wall_s").filter_map(|key| key.strip_suffix("_ms"))
}

/// Statistics of a channel of `/sim/stats`.
fn stat_fields_of(schema: &Map<String, Value>) -> impl Iterator<Item = StatField> {
    schema.iter().filter(|(key, _)| *key != "frame" && *key != "wall_s").map(|(key, about)| {
        let unit = about["unit"].as_str().unwrap_or_default();
        let text = about["description"].as_str().unwrap_or_default();
        StatField::new(key, unit, text.strip_suffix(&format!(" [{unit}]")).unwrap_or(text))
    })
}

/// A file half read.
struct Rows<'n> {
    name: &'n str,
    capture: Capture,
    sequences: SpanReader,
    seen: BTreeMap<String, usize>,
}

impl Rows<'_> {
    /// Takes stages and statistics from the schemas, so that they are known without a message.
    fn describe(&mut self, channel: &Channel) -> Result<(), CaptureError> {
        let topic = channel.topic.as_str();
        if topic != PASSES_TOPIC && topic != STATS_TOPIC {
            return Ok(());
        }
        let schema: Value = serde_json::from_slice(&channel.schema)
            .map_err(|error| self.problem(topic, format!("its schema: {error}")))?;
        let Some(properties) = schema["properties"].as_object() else {
            return Ok(());
        };
        if topic == PASSES_TOPIC {
            for stage in stages_of(properties) {
                if !self.capture.stages.iter().any(|known| known == stage) {
                    self.capture.stages.push(stage.into());
                }
            }
        } else {
            self.capture.stat_fields = stat_fields_of(properties).collect();
        }
        Ok(())
    }

    fn message(&mut self, message: Message<'_>) -> Result<(), CaptureError> {
        let (topic, data) = (message.channel.topic.as_str(), message.data);
        match topic {
            FRAME_TOPIC => {
                let row = self.parse(topic, data)?;
                self.capture.frames.push(row);
            }
            SPAN_TOPIC => {
                let rows = self.sequences.rows(data).map_err(|problem| self.problem(topic, problem))?;
                self.capture.spans.extend(rows);
            }
            STATE_TOPIC => {
                let row = self.parse(topic, data)?;
                self.capture.states.push(row);
            }
            THERMAL_TOPIC => {
                let row = self.parse(topic, data)?;
                self.capture.thermal.push(row);
            }
            CHECK_TOPIC => {
                let row = self.parse(topic, data)?;
                self.capture.checks.push(row);
            }
            PASSES_TOPIC => {
                let (frame, wall_s, values) = self.numbers(topic, data)?;
                let stage_ms = values
                    .into_iter()
                    .filter_map(|(key, ms)| Some((key.strip_suffix("_ms")?.to_string(), ms)))
                    .collect();
                self.capture.passes.push(PassRow { frame, wall_s, stage_ms });
            }
            STATS_TOPIC => {
                let (frame, wall_s, values) = self.numbers(topic, data)?;
                self.capture.stats.push(StatsRow { frame, wall_s, values });
            }
            // Pictures, points and the log; or somebody else's topic in the same file.
            _ => return Ok(()),
        }
        *self.seen.entry(topic.into()).or_default() += 1;
        Ok(())
    }

    fn parse<T: DeserializeOwned>(&self, topic: &str, data: &[u8]) -> Result<T, CaptureError> {
        serde_json::from_slice(data).map_err(|error| self.problem(topic, error.to_string()))
    }

    /// A flat message of numbers: frame, time, and the rest by name.
    fn numbers(&self, topic: &str, data: &[u8]) -> Result<(u64, f64, BTreeMap<String, f64>), CaptureError> {
        let mut fields: Map<String, Value> = self.parse(topic, data)?;
        let frame = fields
            .remove("frame")
            .and_then(|value| value.as_u64())
            .ok_or_else(|| self.problem(topic, "field `frame` is no whole number".into()))?;
        let wall_s = fields
            .remove("wall_s")
            .and_then(|value| value.as_f64())
            .ok_or_else(|| self.problem(topic, "field `wall_s` is no number".into()))?;
        let values = fields
            .into_iter()
            .map(|(key, value)| match value.as_f64() {
                Some(number) => Ok((key, number)),
                None => Err(self.problem(topic, format!("field `{key}` is {value}, no number"))),
            })
            .collect::<Result<_, _>>()?;
        Ok((frame, wall_s, values))
    }

    fn problem(&self, topic: &str, problem: String) -> CaptureError {
        message_problem(self.name, topic, self.seen.get(topic).copied().unwrap_or(0), &problem)
    }
}
