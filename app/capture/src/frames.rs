//! Frames: what a report becomes in the file. Nothing is allocated for a frame that is like one before.

use std::{collections::HashMap, io::Write};

use brooklet_gpu::{FrameReport, Span, SpanFlag};
use serde::{Serialize, Serializer, ser::SerializeMap};

use crate::{
    CaptureError, CaptureWriter, FrameRow,
    rows::{flag_name, timing_name},
    schema::stage_key,
};

/// More sequences than any program has on purpose; beyond, they are forgotten and numbered anew.
const MOST_SEQUENCES: usize = 256;

/// The stages that have a field in `/gpu/passes`.
#[derive(Default)]
pub(crate) struct Stages {
    names: Vec<String>,
    keys: HashMap<String, String>,
}

impl Stages {
    pub fn new(names: Vec<String>) -> Self {
        let mut stages = Self::default();
        for name in names {
            stages.add(&name);
        }
        stages
    }

    /// Whether it is new.
    pub fn add(&mut self, name: &str) -> bool {
        let is_new = !self.keys.contains_key(name);
        if is_new {
            self.keys.insert(name.into(), stage_key(name));
            self.names.push(name.into());
        }
        is_new
    }

    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }
}

/// The sequences of passes that frames ran, by number. Names come with the first message of a chunk that
/// needs them, so that each chunk can be read alone.
#[derive(Default)]
pub(crate) struct Sequences {
    known: Vec<Sequence>,
    next: u32,
}

struct Sequence {
    number: u32,
    passes: Vec<(&'static str, &'static str)>,
    is_told: bool,
}

impl Sequences {
    /// The number of the sequence of `spans`, and whether its names have to be told.
    fn number(&mut self, spans: &[Span]) -> (u32, bool) {
        let names = || spans.iter().map(|span| (span.recording.label(), span.stage));
        if let Some(known) = self.known.iter_mut().find(|known| known.passes.iter().copied().eq(names())) {
            return (known.number, !std::mem::replace(&mut known.is_told, true));
        }
        if self.known.len() == MOST_SEQUENCES {
            self.known.clear();
        }
        let number = self.next;
        self.next = self.next.wrapping_add(1);
        self.known.push(Sequence { number, passes: names().collect(), is_told: true });
        (number, true)
    }

    /// A chunk ended.
    pub fn forget(&mut self) {
        self.known.iter_mut().for_each(|known| known.is_told = false);
    }
}

impl<W: Write> CaptureWriter<W> {
    /// Records a finished frame: its spans, its stages, and the frame as a whole. A stage that was not
    /// declared is from now on.
    ///
    /// # Errors
    /// If writing fails, once.
    pub fn frame(&mut self, report: &FrameReport) -> Result<(), CaptureError> {
        if self.is_broken() {
            return Ok(());
        }
        self.timed(|this| this.write_frame(report))
    }

    fn write_frame(&mut self, report: &FrameReport) -> Result<(), CaptureError> {
        let stage_ms = report.stage_ms();
        let wall_s = report.wall_ns as f64 * 1e-9;
        let mut new_stages = 0;
        for (stage, ..) in &stage_ms {
            new_stages += u32::from(self.stages.add(stage));
        }
        if new_stages > 0 {
            self.declare_passes()?;
        }
        if !report.spans.is_empty() {
            if self.frames.is_multiple_of(self.spans_every) {
                let (sequence, tells) = self.sequences.number(&report.spans);
                self.message(self.channels.span, report.wall_ns, &SpansMessage { report, sequence, tells })?;
            }
            let stages = std::mem::take(&mut self.stages);
            let passes = PassesMessage { frame: report.frame, wall_s, stage_ms: &stage_ms, keys: &stages.keys };
            let written = self.message(self.channels.passes, report.wall_ns, &passes);
            self.stages = stages;
            written?;
        }
        self.tie.add(report);
        let count = |flag| report.spans.iter().filter(|span| span.flag == flag).count() as u32;
        let row = FrameRow {
            frame: report.frame,
            wall_s,
            gpu_ms: report.gpu_ms(),
            pass_sum_ms: (!stage_ms.is_empty()).then(|| stage_ms.iter().map(|(_, ms, _)| ms).sum()),
            timing: timing_name(report.timing).into(),
            spans: report.spans.len() as u32,
            flagged_spans: report.flagged() as u32,
            zero_spans: count(SpanFlag::Zero),
            negative_spans: count(SpanFlag::Negative),
            overlapping_spans: count(SpanFlag::Overlapping),
            gap_spans: count(SpanFlag::Gap),
            dropped_spans: report.dropped_spans,
            // Numbers that go back are another engine's, whose frames begin anew.
            dropped_frames: self.last_frame.map_or(0, |last| report.frame.saturating_sub(last.saturating_add(1))),
            capture_ms: self.spent_since_frame().as_secs_f64() * 1e3,
        };
        self.last_frame = Some(report.frame);
        self.trust.add(&row);
        self.message(self.channels.frame, report.wall_ns, &row)?;
        self.frames += u64::from(!self.is_broken());
        self.flush_when_due()
    }
}

/// Rounded to what a tick is worth at best; a shorter text.
fn to_nanoseconds(ms: f64) -> f64 {
    (ms * 1e6).round() / 1e6
}

struct PassesMessage<'a> {
    frame: u64,
    wall_s: f64,
    stage_ms: &'a [(&'static str, f64, u32)],
    keys: &'a HashMap<String, String>,
}

impl Serialize for PassesMessage<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("frame", &self.frame)?;
        map.serialize_entry("wall_s", &self.wall_s)?;
        for (stage, ms, _) in self.stage_ms {
            if let Some(key) = self.keys.get(*stage) {
                map.serialize_entry(key, &to_nanoseconds(*ms))?;
            }
        }
        map.end()
    }
}

struct SpansMessage<'a> {
    report: &'a FrameReport,
    sequence: u32,
    tells: bool,
}

impl Serialize for SpansMessage<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let spans = self.report.spans.iter();
        let first = self.report.spans.first().map_or(0, |span| span.begin_ticks);
        let begins = spans.clone().map(|span| span.begin_ticks.wrapping_sub(first) as i64);
        let lengths = spans.clone().map(|span| span.end_ticks.wrapping_sub(span.begin_ticks) as i64);
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("frame", &self.report.frame)?;
        map.serialize_entry("sequence", &self.sequence)?;
        if self.tells {
            map.serialize_entry("passes", &List(spans.clone().map(Named)))?;
        }
        map.serialize_entry("first_ticks", &first)?;
        map.serialize_entry("begin_ticks", &List(begins))?;
        map.serialize_entry("ticks", &List(lengths))?;
        if self.report.flagged() > 0 {
            map.serialize_entry("flags", &List(spans.map(|span| flag_name(span.flag))))?;
        }
        map.end()
    }
}

/// What an iterator gives, as a list.
struct List<I>(I);

impl<I: Iterator<Item: Serialize> + Clone> Serialize for List<I> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.clone())
    }
}

/// A pass as `recording/stage`.
struct Named<'a>(&'a Span);

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{}/{}", self.0.recording.label(), self.0.stage))
    }
}
