//! What a capture says, in numbers. Reads a file of any length with one chunk and a bounded sample of each
//! stage's times in memory.

use std::{collections::BTreeMap, path::Path};

use serde::Serialize;

use crate::{
    CaptureError, Ending, FRAME_TOPIC, FrameRow, Item, Message, PASSES_TOPIC, Quantiles, STATE_TOPIC, StateRow,
    THERMAL_TOPIC, ThermalRow, Trust,
    series::{Sample, StageNumbers},
    stream::{message_problem, read_file},
};

/// States and attachments that are kept by name; further ones are counted.
const MOST_KEPT: usize = 1000;

/// Metadata records by name.
pub type Metadata = BTreeMap<String, BTreeMap<String, String>>;

/// What a capture says.
#[derive(Clone, Debug, Default, Serialize)]
pub struct CaptureSummary {
    /// How the file ended.
    pub ending: Ending,
    /// Messages of each topic.
    pub topics: BTreeMap<String, u64>,
    /// From the first event to the last, s.
    pub duration_s: f64,
    /// How the times were taken: of the last frame that has any.
    pub timing: String,
    /// How far they can be believed, counted anew.
    pub trust: Trust,
    /// A frame on the GPU, ms.
    pub frame_ms: Option<Quantiles>,
    /// Processor time of capturing a frame, ms.
    pub capture_ms: Option<Quantiles>,
    /// Stages in order of their first run, ms.
    pub passes: Vec<(String, Quantiles)>,
    /// Changes of state, the first ones.
    pub states: Vec<StateRow>,
    /// Hottest of all sensors, degC.
    pub hottest_c: Option<f64>,
    /// Where power came from, at any time.
    pub power_sources: Vec<String>,
    /// Metadata.
    pub metadata: Metadata,
    /// Attached files: name and bytes.
    pub attachments: Vec<(String, usize)>,
}

#[derive(Default)]
struct Summing {
    summary: CaptureSummary,
    stages: StageNumbers,
    passes: Vec<Sample>,
    frame: Sample,
    capture: Sample,
    times_ns: Option<(u64, u64)>,
    topics: Vec<(u16, String, u64)>,
}

/// Reads a capture.
///
/// # Errors
/// If the file cannot be read, is no capture of this version, or a message does not fit its topic. Damage
/// is no error: [`Ending`] tells.
pub fn summarize(path: &Path) -> Result<CaptureSummary, CaptureError> {
    let name = path.display().to_string();
    let mut summing = Summing::default();
    let ending = read_file(path, &mut |item| {
        match item {
            Item::Message(message) => {
                return summing
                    .message(message)
                    .map_err(|error| message_problem(&name, &message.channel.topic, 0, &error.to_string()));
            }
            Item::Metadata(name, fields) => {
                summing.summary.metadata.insert(name.into(), fields.clone());
            }
            Item::Attachment(attachment) if summing.summary.attachments.len() < MOST_KEPT => {
                summing.summary.attachments.push((attachment.name.clone(), attachment.data.len()));
            }
            _ => {}
        }
        Ok(())
    })?;
    Ok(summing.end(ending))
}

impl Summing {
    fn message(&mut self, message: Message<'_>) -> Result<(), serde_json::Error> {
        let (first, last) = self.times_ns.get_or_insert((message.publish_time, message.publish_time));
        *first = (*first).min(message.publish_time);
        *last = (*last).max(message.publish_time);
        match self.topics.iter_mut().find(|(id, ..)| *id == message.channel.id) {
            Some((_, _, count)) => *count += 1,
            None => self.topics.push((message.channel.id, message.channel.topic.clone(), 1)),
        }
        match message.channel.topic.as_str() {
            FRAME_TOPIC => {
                let row: FrameRow = serde_json::from_slice(message.data)?;
                row.gpu_ms.into_iter().for_each(|ms| self.frame.add(ms));
                self.capture.add(row.capture_ms);
                self.summary.trust.add(&row);
                if row.timing != self.summary.timing && (row.spans > 0 || self.summary.timing.is_empty()) {
                    self.summary.timing = row.timing;
                }
            }
            PASSES_TOPIC => {
                let passes = &mut self.passes;
                self.stages.read(message.data, &mut |stage, ms| {
                    if stage >= passes.len() {
                        passes.resize_with(stage + 1, Sample::default);
                    }
                    passes[stage].add(ms);
                })?;
            }
            STATE_TOPIC if self.summary.states.len() < MOST_KEPT => {
                self.summary.states.push(serde_json::from_slice(message.data)?);
            }
            THERMAL_TOPIC => {
                let row: ThermalRow = serde_json::from_slice(message.data)?;
                let hottest = &mut self.summary.hottest_c;
                *hottest = [*hottest, row.hottest_c].into_iter().flatten().reduce(f64::max);
                let sources = &mut self.summary.power_sources;
                sources.extend(row.power_source.filter(|source| !sources.contains(source) && sources.len() < 8));
            }
            _ => {}
        }
        Ok(())
    }

    fn end(mut self, ending: Ending) -> CaptureSummary {
        let summary = &mut self.summary;
        summary.ending = ending;
        for (_, topic, count) in self.topics {
            *summary.topics.entry(topic).or_default() += count;
        }
        summary.duration_s = self.times_ns.map_or(0.0, |(first, last)| (last - first) as f64 * 1e-9);
        summary.frame_ms = self.frame.quantiles();
        summary.capture_ms = self.capture.quantiles();
        summary.passes = self
            .stages
            .names
            .into_iter()
            .zip(&self.passes)
            .filter_map(|(name, sample)| Some((name, sample.quantiles()?)))
            .collect();
        if let Some(raised) = summary.metadata.get("trust").and_then(|trust| trust.get("log_times_raised")) {
            summary.trust.log_times_raised = raised.parse().unwrap_or(0);
        }
        self.summary
    }
}
