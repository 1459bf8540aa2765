//! Writes a capture: chunks in memory, appended whole, about one a second.

use std::{
    collections::{BTreeMap, HashSet},
    fs::File,
    io::{BufWriter, Read, Seek, Write},
    path::Path,
    time::{Duration, Instant, SystemTime, UNIX_EPOCH},
};

use brooklet_gpu::{DeviceInfo, FrameReport};
use mcap::{MAGIC, WriteOptions, Writer, records::MessageHeader, records::Metadata, write::NoSeek};
use serde::Serialize;
use serde_json::{Map, Value};

use crate::{
    CaptureError, FrameRow, SpanRow, StatField,
    rows::{flag_name, timing_name},
    schema::{
        FRAME_TOPIC, PASSES_TOPIC, SPAN_TOPIC, STATS_TOPIC, frame_schema, passes_schema, span_schema, stage_key,
        stats_schema,
    },
    sink::StickySink,
};

/// What a capture has to know before its first frame.
#[derive(Clone, Debug)]
pub struct CaptureOptions {
    /// The stages that may run, for the schema of `/gpu/passes`.
    pub stages: Vec<String>,
    /// The statistics that will be given; none: there is no `/sim/stats`.
    pub stats: Vec<StatField>,
    /// The moment that `wall_ns == 0` of the frame reports stands for: when the engine started.
    pub start: SystemTime,
    /// How long a chunk collects before it is written.
    pub flush_every: Duration,
}

impl Default for CaptureOptions {
    fn default() -> Self {
        Self { stages: Vec::new(), stats: Vec::new(), start: SystemTime::now(), flush_every: Duration::from_secs(1) }
    }
}

/// What a finished capture holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CaptureTotals {
    /// Frames written.
    pub frames: u64,
    /// Messages written on all topics.
    pub messages: u64,
    /// Processor time that capturing took in all, ms.
    pub capture_ms: f64,
    /// Whether everything was written; false after a write error.
    pub complete: bool,
}

type Sink<W> = NoSeek<BufWriter<StickySink<W>>>;

/// Channel ids in the file.
struct Channels {
    frame: u16,
    passes: u16,
    span: u16,
    stats: Option<u16>,
}

/// Writes one capture.
///
/// A write error is returned once, by the call that met it. After that every call succeeds and
/// does nothing, so that a run may go on without its capture; [`CaptureWriter::is_broken`] and
/// [`CaptureTotals::complete`] tell.
pub struct CaptureWriter<W: Write> {
    name: String,
    writer: Option<Writer<Sink<W>>>,
    channels: Channels,
    stats: Vec<StatField>,
    start_ns: u64,
    flush_every: Duration,
    last_flush: Instant,
    sequence: u32,
    frames: u64,
    messages: u64,
    call_begun: Instant,
    spent: Duration,
    spent_reported: Duration,
}

impl CaptureWriter<File> {
    /// Creates the file `path`. A capture that is there is replaced; any other file is kept, and an
    /// error.
    pub fn create(path: &Path, options: CaptureOptions) -> Result<Self, CaptureError> {
        let name = path.display().to_string();
        let io = |source| CaptureError::Io { name: name.clone(), action: "create", source };
        // Not created anew: a name typed wrongly must not cost anybody a file.
        let mut file = File::options().read(true).write(true).create(true).truncate(false).open(path).map_err(io)?;
        if file.metadata().map_err(io)?.is_file() {
            let mut start = Vec::new();
            (&mut file).take(MAGIC.len() as u64).read_to_end(&mut start).map_err(io)?;
            if !MAGIC.starts_with(&start) {
                return Err(CaptureError::NotReplaced { name });
            }
            file.set_len(0).and_then(|()| file.rewind()).map_err(io)?;
        }
        Self::new(file, name, options)
    }
}

impl<W: Write> CaptureWriter<W> {
    /// Writes to `to`, which is only appended to; `name` is what errors call it.
    pub fn new(to: W, name: String, options: CaptureOptions) -> Result<Self, CaptureError> {
        check_fields(&options.stats)?;
        let sink = NoSeek::new(BufWriter::new(StickySink::new(to)));
        // Without seeking a chunk is collected in memory and appended whole: what is on disk is
        // at any moment a capture with a clean end.
        let opened = WriteOptions::new()
            .compression(None)
            .disable_seeking(true)
            .library(concat!("brooklet-capture ", env!("CARGO_PKG_VERSION")))
            .create(sink)
            .and_then(|mut writer| {
                let channels = add_channels(&mut writer, &options)?;
                writer.flush()?;
                Ok((writer, channels))
            });
        let (writer, channels) = opened.map_err(|source| CaptureError::write(&name, 0, source))?;
        Ok(Self {
            name,
            writer: Some(writer),
            channels,
            stats: options.stats,
            start_ns: epoch_ns(options.start),
            flush_every: options.flush_every,
            last_flush: Instant::now(),
            sequence: 0,
            frames: 0,
            messages: 0,
            call_begun: Instant::now(),
            spent: Duration::ZERO,
            spent_reported: Duration::ZERO,
        })
    }

    /// Whether a write failed: nothing is recorded any more.
    pub fn is_broken(&self) -> bool {
        self.writer.is_none()
    }

    /// Records the device, its driver and its limits as metadata `device` and `limits`, with the
    /// tier in use.
    pub fn device(&mut self, device: &DeviceInfo, tier: &str) -> Result<(), CaptureError> {
        let fields = [
            ("name", device.name.clone()),
            ("driver", device.driver.clone()),
            ("driver_info", device.driver_info.clone()),
            ("backend", device.backend.clone()),
            ("device_type", device.device_type.clone()),
            ("vendor", format!("{:#06x}", device.vendor)),
            ("device_id", format!("{:#06x}", device.device)),
            ("timestamp_period_ns", device.timestamp_period_ns.to_string()),
            ("tier", tier.to_string()),
        ];
        self.metadata("device", fields)?;
        let limits = device.limits.iter().map(|(name, value)| (name.to_string(), value.to_string()));
        self.metadata("limits", limits)
    }

    /// Records facts that hold for the whole run as metadata `name`.
    pub fn metadata<K: Into<String>>(
        &mut self,
        name: &str,
        fields: impl IntoIterator<Item = (K, String)>,
    ) -> Result<(), CaptureError> {
        let metadata: BTreeMap<String, String> = fields.into_iter().map(|(k, v)| (k.into(), v)).collect();
        let record = Metadata { name: name.into(), metadata };
        self.timed(|this| {
            this.write(|writer, _| {
                writer.write_metadata(&record)?;
                writer.flush()
            })
        })
    }

    /// Records a whole file: a scene, a settings text.
    pub fn attach(&mut self, name: &str, media_type: &str, data: &[u8]) -> Result<(), CaptureError> {
        let now_ns = epoch_ns(SystemTime::now());
        let attachment = mcap::Attachment {
            log_time: now_ns,
            create_time: now_ns,
            name: name.into(),
            media_type: media_type.into(),
            data: data.into(),
        };
        self.timed(|this| {
            this.write(|writer, _| {
                writer.attach(&attachment)?;
                writer.flush()
            })
        })
    }

    /// Records a finished frame: its spans, its stages, and the frame as a whole.
    pub fn frame(&mut self, report: &FrameReport) -> Result<(), CaptureError> {
        if self.is_broken() {
            return Ok(());
        }
        self.timed(|this| this.write_frame(report))
    }

    fn write_frame(&mut self, report: &FrameReport) -> Result<(), CaptureError> {
        let wall_s = report.wall_ns as f64 * 1e-9;
        let stage_ms = report.stage_ms();
        let has_times = !stage_ms.is_empty();

        let mut passes = Map::new();
        passes.insert("frame".into(), report.frame.into());
        passes.insert("wall_s".into(), wall_s.into());
        for (stage, ms, _) in &stage_ms {
            passes.insert(stage_key(stage), (*ms).into());
        }
        let spans: Vec<SpanRow> = report
            .spans
            .iter()
            .map(|span| SpanRow {
                frame: report.frame,
                recording: span.recording.into(),
                stage: span.stage.into(),
                begin_ticks: span.begin_ticks,
                end_ticks: span.end_ticks,
                flag: flag_name(span.flag).into(),
            })
            .collect();
        let log_ns = self.start_ns + report.wall_ns;
        let (frame, span, pass) = (self.channels.frame, self.channels.span, self.channels.passes);
        self.write(|writer, out| {
            for row in &spans {
                out.message(writer, span, log_ns, row)?;
            }
            if has_times {
                out.message(writer, pass, log_ns, &passes)?;
            }
            Ok(())
        })?;
        let spent = self.spent + self.call_begun.elapsed();
        let row = FrameRow {
            frame: report.frame,
            wall_s,
            gpu_ms: report.gpu_ms(),
            pass_sum_ms: has_times.then(|| stage_ms.iter().map(|(_, ms, _)| ms).sum()),
            timing: timing_name(report.timing).into(),
            spans: report.spans.len() as u32,
            flagged_spans: report.flagged() as u32,
            capture_ms: (spent - self.spent_reported).as_secs_f64() * 1e3,
        };
        self.spent_reported = spent;
        self.write(|writer, out| out.message(writer, frame, log_ns, &row))?;
        self.frames += u64::from(self.writer.is_some());
        self.flush_when_due()
    }

    /// Records the declared statistics, in the order they were declared; `frame` and `wall_ns`
    /// are those of the frame they were measured in.
    pub fn stats(&mut self, frame: u64, wall_ns: u64, values: &[f64]) -> Result<(), CaptureError> {
        if values.len() != self.stats.len() {
            return Err(CaptureError::StatCount {
                name: self.name.clone(),
                given: values.len(),
                declared: self.stats.len(),
            });
        }
        let Some(channel) = self.channels.stats else {
            return Ok(());
        };
        let mut row = Map::new();
        row.insert("frame".into(), frame.into());
        row.insert("wall_s".into(), (wall_ns as f64 * 1e-9).into());
        for (field, value) in self.stats.iter().zip(values) {
            // `Value::from` makes null of what is not finite; a plotting tool wants a gap.
            let value = Value::from(*value);
            if !value.is_null() {
                row.insert(field.name.clone(), value);
            }
        }
        let log_ns = self.start_ns + wall_ns;
        self.timed(|this| {
            this.write(|writer, out| out.message(writer, channel, log_ns, &row))?;
            this.flush_when_due()
        })
    }

    /// Writes what was collected as a chunk, now.
    pub fn flush(&mut self) -> Result<(), CaptureError> {
        self.timed(Self::write_chunk)
    }

    fn write_chunk(&mut self) -> Result<(), CaptureError> {
        self.last_flush = Instant::now();
        self.write(|writer, _| writer.flush())
    }

    /// Writes the last chunk and the file's summary section.
    pub fn finish(mut self) -> Result<CaptureTotals, CaptureError> {
        self.timed(|this| {
            this.write(|writer, _| {
                writer.finish()?;
                Ok(())
            })
        })?;
        // `finish` leaves the end of the file in the buffer; only this says whether it arrived.
        let mut complete = false;
        if let Some(writer) = self.writer.take() {
            let mut rest = writer.into_inner().into_inner();
            rest.flush().map_err(|source| CaptureError::write(&self.name, self.frames, source.into()))?;
            complete = true;
        }
        Ok(CaptureTotals {
            frames: self.frames,
            messages: self.messages,
            capture_ms: self.spent.as_secs_f64() * 1e3,
            complete,
        })
    }

    fn flush_when_due(&mut self) -> Result<(), CaptureError> {
        if self.last_flush.elapsed() >= self.flush_every { self.write_chunk() } else { Ok(()) }
    }

    /// Runs `job`, a call from outside, and counts its time as the capture's.
    fn timed<T>(&mut self, job: impl FnOnce(&mut Self) -> T) -> T {
        self.call_begun = Instant::now();
        let result = job(self);
        self.spent += self.call_begun.elapsed();
        result
    }

    /// Runs `job` on the open file; the first failure closes it. Nothing to do on a closed one.
    fn write(
        &mut self,
        job: impl FnOnce(&mut Writer<Sink<W>>, &mut Messages) -> mcap::McapResult<()>,
    ) -> Result<(), CaptureError> {
        let Some(writer) = &mut self.writer else {
            return Ok(());
        };
        let mut out = Messages { sequence: self.sequence, count: 0 };
        let result = job(writer, &mut out);
        self.sequence = out.sequence;
        self.messages += out.count;
        result.map_err(|source| {
            self.writer = None;
            CaptureError::write(&self.name, self.frames, source)
        })
    }
}

/// Numbers the messages.
struct Messages {
    sequence: u32,
    count: u64,
}

impl Messages {
    fn message<W: Write>(
        &mut self,
        writer: &mut Writer<Sink<W>>,
        channel_id: u16,
        log_ns: u64,
        row: &impl Serialize,
    ) -> mcap::McapResult<()> {
        let data = serde_json::to_vec(row).map_err(std::io::Error::from)?;
        let header = MessageHeader { channel_id, sequence: self.sequence, log_time: log_ns, publish_time: log_ns };
        writer.write_to_known_channel(&header, &data)?;
        self.sequence = self.sequence.wrapping_add(1);
        self.count += 1;
        Ok(())
    }
}

fn add_channels<W: Write>(writer: &mut Writer<Sink<W>>, options: &CaptureOptions) -> mcap::McapResult<Channels> {
    let mut add = |topic: &str, name: &str, schema: &Value| {
        let text = serde_json::to_vec_pretty(schema).map_err(std::io::Error::from)?;
        let schema_id = writer.add_schema(name, "jsonschema", &text)?;
        writer.add_channel(schema_id, topic, "json", &BTreeMap::new())
    };
    Ok(Channels {
        frame: add(FRAME_TOPIC, "brooklet.Frame", &frame_schema())?,
        passes: add(PASSES_TOPIC, "brooklet.Passes", &passes_schema(&options.stages))?,
        span: add(SPAN_TOPIC, "brooklet.Span", &span_schema())?,
        stats: if options.stats.is_empty() {
            None
        } else {
            Some(add(STATS_TOPIC, "brooklet.Stats", &stats_schema(&options.stats))?)
        },
    })
}

fn check_fields(stats: &[StatField]) -> Result<(), CaptureError> {
    let mut seen = HashSet::from(["frame", "wall_s"]);
    for stat in stats {
        if !seen.insert(&stat.name) {
            return Err(CaptureError::StatField {
                field: stat.name.clone(),
                problem: "is given twice, or is one of the format's own (frame, wall_s)",
            });
        }
    }
    Ok(())
}

fn epoch_ns(moment: SystemTime) -> u64 {
    moment.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_nanos() as u64)
}
