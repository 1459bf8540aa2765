//! Reads a capture, also one that was cut off.

use std::{
    collections::BTreeMap,
    fs::File,
    io::{BufReader, ErrorKind, Read},
    path::Path,
};

use mcap::{
    MAGIC, McapError,
    read::ChannelAccumulator,
    records::{Record, op},
    sans_io::linear_reader::{LinearReadEvent, LinearReader, LinearReaderOptions},
};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::framing::{compression, is_wanted, records_of};
use crate::{
    CaptureError, FRAME_TOPIC, FrameRow, PASSES_TOPIC, PassRow, SPAN_TOPIC, STATS_TOPIC, SpanRow, StatField, StatsRow,
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

/// Everything a capture holds, each list in the order of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Capture {
    /// `/gpu/frame`.
    pub frames: Vec<FrameRow>,
    /// `/gpu/passes`.
    pub passes: Vec<PassRow>,
    /// `/gpu/span`.
    pub spans: Vec<SpanRow>,
    /// `/sim/stats`.
    pub stats: Vec<StatsRow>,
    /// The stages of the plan, from the schema of `/gpu/passes`, whether or not they ran.
    pub stages: Vec<String>,
    /// The named statistics, from the schema of `/sim/stats`.
    pub stat_fields: Vec<StatField>,
    /// Metadata records by name: `device`, `limits`, `build` and whatever the program added.
    pub metadata: BTreeMap<String, BTreeMap<String, String>>,
    /// Attached files.
    pub attachments: Vec<Attachment>,
    /// Whether the file has its proper end. When not, this is every complete chunk of a file
    /// that was cut off or damaged behind them.
    pub complete: bool,
}

impl Capture {
    /// Reads the file `path`.
    ///
    /// A file that was cut off is no error: every complete chunk is returned, with
    /// [`Capture::complete`] false.
    pub fn open(path: &Path) -> Result<Self, CaptureError> {
        let name = path.display().to_string();
        let io = |action, source| CaptureError::Io { name: name.clone(), action, source };
        let file = File::open(path).map_err(|e| io("open", e))?;
        let length = file.metadata().map_err(|e| io("open", e))?.len();
        Self::read(BufReader::new(file), length, &name)
    }

    /// Reads a capture of at most `length` bytes from `from`; `name` is what errors call it.
    pub fn read(mut from: impl Read, length: u64, name: &str) -> Result<Self, CaptureError> {
        let io = |source| CaptureError::Io { name: name.into(), action: "read", source };
        let mut start = Vec::new();
        from.by_ref().take(MAGIC.len() as u64).read_to_end(&mut start).map_err(io)?;
        if start != MAGIC {
            return Err(not_mcap(name, &start));
        }
        let mut from = start.as_slice().chain(from);
        let mut file = Reading::new(name);
        let mut reader = LinearReader::new_with_options(
            LinearReaderOptions::default()
                // A chunk's messages are seen only when all of it is there and its checksum fits.
                .with_emit_chunks(true)
                // What damage left behind as a record of no known kind is skipped; this tells.
                .with_validate_data_section_crc(true)
                // A damaged length must not ask for more memory than the file could fill.
                .with_record_length_limit(usize::try_from(length).unwrap_or(usize::MAX)),
        );
        while let Some(event) = reader.next_event() {
            match event {
                Ok(LinearReadEvent::ReadRequest(need)) => {
                    let got = read_some(&mut from, reader.insert(need)).map_err(io)?;
                    reader.notify_read(got);
                }
                Ok(LinearReadEvent::Record { opcode, .. }) if !is_wanted(opcode) => {}
                Ok(LinearReadEvent::Record { opcode: op::CHUNK, data }) if compression(data).is_some() => {
                    return Err(CaptureError::Compressed {
                        name: name.into(),
                        compression: compression(data).unwrap_or_default().into(),
                    });
                }
                Ok(LinearReadEvent::Record { opcode, data }) => match records_of(opcode, data) {
                    Some(records) => records.into_iter().try_for_each(|record| file.record(record))?,
                    None => return file.end(false),
                },
                // Cut off or damaged here: what came before is whole.
                Err(_) => return file.end(false),
            }
        }
        file.end(true)
    }

    /// Times of one stage over the run, ms, in order of the frames it ran in.
    pub fn stage_ms(&self, stage: &str) -> Vec<f64> {
        self.passes.iter().filter_map(|row| row.stage_ms.get(stage).copied()).collect()
    }
}

fn read_some(from: &mut impl Read, into: &mut [u8]) -> std::io::Result<usize> {
    loop {
        match from.read(into) {
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            result => return result,
        }
    }
}

/// A name from the file, without what would break or colour the line of an error.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}

fn not_mcap(name: &str, start: &[u8]) -> CaptureError {
    let found = if start.is_empty() {
        "nothing (it is empty)".into()
    } else {
        let hex: Vec<String> = start.iter().map(|byte| format!("{byte:02x}")).collect();
        hex.join(" ")
    };
    CaptureError::NotMcap { name: name.into(), found }
}

/// A file half read.
struct Reading<'n> {
    name: &'n str,
    capture: Capture,
    channels: ChannelAccumulator<'static>,
    topics: Vec<String>,
    /// The summary section repeats schemas and channels; it has no messages of its own.
    seen: BTreeMap<String, usize>,
}

impl<'n> Reading<'n> {
    fn new(name: &'n str) -> Self {
        Self {
            name,
            capture: Capture::default(),
            channels: ChannelAccumulator::default(),
            topics: Vec::new(),
            seen: BTreeMap::new(),
        }
    }

    fn record(&mut self, record: Record<'_>) -> Result<(), CaptureError> {
        match record {
            Record::Schema { header, data } => {
                let added = self.channels.add_schema_from_slice(header, &data);
                self.checked("schema", added)
            }
            Record::Channel(channel) => {
                let (id, topic) = (channel.id, channel.topic.clone());
                let added = self.channels.add_channel(channel);
                self.checked(&topic, added)?;
                if !self.topics.contains(&topic) {
                    self.describe(id, &topic)?;
                    self.topics.push(topic);
                }
                Ok(())
            }
            Record::Message { header, data } => self.message(header.channel_id, &data),
            Record::Metadata(record) => {
                self.capture.metadata.insert(record.name, record.metadata);
                Ok(())
            }
            Record::Attachment { header, data, .. } => {
                self.capture.attachments.push(Attachment {
                    name: header.name,
                    media_type: header.media_type,
                    data: data.into_owned(),
                });
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Takes stages and statistics from the schemas, so that they are known without a message.
    fn describe(&mut self, channel: u16, topic: &str) -> Result<(), CaptureError> {
        if topic != PASSES_TOPIC && topic != STATS_TOPIC {
            return Ok(());
        }
        let Some(schema) = self.channels.get(channel).and_then(|c| c.schema.clone()) else {
            return Ok(());
        };
        let schema: Value = serde_json::from_slice(&schema.data)
            .map_err(|error| self.problem(topic, format!("its schema: {error}")))?;
        let Some(properties) = schema["properties"].as_object() else {
            return Ok(());
        };
        for (key, about) in properties {
            if key == "frame" || key == "wall_s" {
                continue;
            }
            if topic == PASSES_TOPIC {
                self.capture.stages.extend(key.strip_suffix("_ms").map(Into::into));
            } else {
                let unit = about["unit"].as_str().unwrap_or_default();
                let text = about["description"].as_str().unwrap_or_default();
                let text = text.strip_suffix(&format!(" [{unit}]")).unwrap_or(text);
                self.capture.stat_fields.push(StatField::new(key, unit, text));
            }
        }
        Ok(())
    }

    fn message(&mut self, channel: u16, data: &[u8]) -> Result<(), CaptureError> {
        let Some(channel) = self.channels.get(channel) else {
            return Err(self.problem("?", format!("channel {channel} is not declared")));
        };
        match channel.topic.as_str() {
            FRAME_TOPIC => {
                let row = self.parse(FRAME_TOPIC, data)?;
                self.capture.frames.push(row);
            }
            SPAN_TOPIC => {
                let row = self.parse(SPAN_TOPIC, data)?;
                self.capture.spans.push(row);
            }
            PASSES_TOPIC => {
                let (frame, wall_s, values) = self.numbers(PASSES_TOPIC, data)?;
                let stage_ms = values
                    .into_iter()
                    .filter_map(|(key, ms)| Some((key.strip_suffix("_ms")?.to_string(), ms)))
                    .collect();
                self.capture.passes.push(PassRow { frame, wall_s, stage_ms });
            }
            STATS_TOPIC => {
                let (frame, wall_s, values) = self.numbers(STATS_TOPIC, data)?;
                self.capture.stats.push(StatsRow { frame, wall_s, values });
            }
            // Somebody else's topic in the same file.
            _ => return Ok(()),
        }
        *self.seen.entry(channel.topic.clone()).or_default() += 1;
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

    fn checked(&self, topic: &str, result: Result<(), McapError>) -> Result<(), CaptureError> {
        result.map_err(|error| self.problem(topic, error.to_string()))
    }

    fn problem(&self, topic: &str, problem: String) -> CaptureError {
        CaptureError::Message {
            name: self.name.into(),
            topic: printable(topic),
            index: self.seen.get(topic).copied().unwrap_or(0),
            problem: printable(&problem),
        }
    }

    fn end(mut self, complete: bool) -> Result<Capture, CaptureError> {
        let known = [FRAME_TOPIC, PASSES_TOPIC, SPAN_TOPIC, STATS_TOPIC];
        // A file cut before its first chunk has no topics yet, and is still a capture.
        if complete && !self.topics.iter().any(|topic| known.contains(&topic.as_str())) {
            let topics = if self.topics.is_empty() { "none".into() } else { printable(&self.topics.join(", ")) };
            return Err(CaptureError::NotACapture { name: self.name.into(), topics });
        }
        self.capture.complete = complete;
        Ok(self.capture)
    }
}
