//! Writes a capture: chunks in memory, appended whole, about one a second.

use std::{
    collections::{BTreeMap, HashSet},
    fs::File,
    io::{BufWriter, Read, Seek, Write},
    path::Path,
    time::{Duration, Instant, SystemTime},
};

use brooklet_gpu::{DeviceInfo, Plan};
use mcap::{MAGIC, WriteOptions, Writer, records::MessageHeader, records::Metadata, write::NoSeek};
use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::{
    CaptureCost, CaptureError, StatField, Trust,
    clock::{LogClock, TickTie, epoch_ns, statement},
    events::EventChannels,
    frames::{Sequences, Stages},
    schema::{
        FORMAT_KEY, FORMAT_VERSION, FRAME_TOPIC, PASSES_TOPIC, SPAN_TOPIC, STATS_TOPIC, frame_schema, passes_schema,
        span_schema, stats_schema,
    },
    sink::StickySink,
};

/// A chunk of this size is written before its time has come.
const CHUNK_BYTES: u64 = 1 << 20;

/// What a capture has to know before its first frame.
#[derive(Clone, Debug)]
pub struct CaptureOptions {
    /// The stages that may run, for the schema of `/gpu/passes`; those of a frame that are not among them
    /// are added when they come.
    pub stages: Vec<String>,
    /// The statistics that will be given; none: there is no `/sim/stats`.
    pub stats: Vec<StatField>,
    /// The moment that `wall_ns == 0` stands for, in the frame reports and in every call: when the engine
    /// started, or a [`crate::CaptureClock`]'s.
    pub start: SystemTime,
    /// Raw ticks are written of every so many frames; the other topics have every frame. 1: of each.
    pub spans_every: u32,
    /// How long a chunk collects before it is written.
    pub flush_every: Duration,
}

impl Default for CaptureOptions {
    fn default() -> Self {
        Self {
            stages: Vec::new(),
            stats: Vec::new(),
            start: SystemTime::now(),
            spans_every: 1,
            flush_every: Duration::from_secs(1),
        }
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
    /// How far the times can be believed.
    pub trust: Trust,
}

type Sink<W> = NoSeek<BufWriter<StickySink<W>>>;

/// Channel ids in the file.
pub(crate) struct Channels {
    pub frame: u16,
    pub passes: u16,
    pub span: u16,
    pub stats: Option<u16>,
}

/// Writes one capture.
///
/// A write error is returned once, by the call that met it. After that every call succeeds and
/// does nothing, so that a run may go on without its capture; [`CaptureWriter::is_broken`] and
/// [`CaptureTotals::complete`] tell.
pub struct CaptureWriter<W: Write> {
    name: String,
    writer: Option<Writer<Sink<W>>>,
    pub(crate) channels: Channels,
    pub(crate) events: EventChannels,
    pub(crate) stages: Stages,
    pub(crate) sequences: Sequences,
    stats: Vec<StatField>,
    clock: LogClock,
    pub(crate) tie: TickTie,
    pub(crate) trust: Trust,
    pub(crate) last_frame: Option<u64>,
    /// A message while it is made; kept, so that making one allocates nothing.
    buffer: Vec<u8>,
    pub(crate) spans_every: u64,
    flush_every: Duration,
    last_flush: Instant,
    bytes: u64,
    chunk_begin: u64,
    sequence: u32,
    pub(crate) frames: u64,
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
        let stages = Stages::new(options.stages);
        let clock = LogClock::new(options.start);
        // Without seeking a chunk is collected in memory and appended whole: what is on disk is
        // at any moment a capture with a clean end. Chunks end where we say.
        let opened = WriteOptions::new()
            .compression(None)
            .disable_seeking(true)
            .chunk_size(None)
            .library(concat!("brooklet-capture ", env!("CARGO_PKG_VERSION")))
            .create(sink)
            .and_then(|mut writer| {
                let channels = add_channels(&mut writer, &stages, &options.stats)?;
                writer.write_metadata(&record("clocks", statement(clock.start_ns)))?;
                writer.flush()?;
                Ok((writer, channels))
            });
        let (writer, channels) = opened.map_err(|source| CaptureError::write(&name, 0, source))?;
        Ok(Self {
            name,
            writer: Some(writer),
            channels,
            events: EventChannels::default(),
            stages,
            sequences: Sequences::default(),
            stats: options.stats,
            clock,
            tie: TickTie::default(),
            trust: Trust::default(),
            last_frame: None,
            buffer: Vec::new(),
            spans_every: u64::from(options.spans_every.max(1)),
            flush_every: options.flush_every,
            last_flush: Instant::now(),
            bytes: 0,
            chunk_begin: 0,
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

    /// Bytes of messages given so far; the file has a little more.
    pub fn bytes_written(&self) -> u64 {
        self.bytes
    }

    /// How far the times so far can be believed.
    pub fn trust(&self) -> &Trust {
        &self.trust
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

    /// Attaches a plan as `plan.json` (its passes, and the bytes it keeps) and the modules it runs as
    /// `shaders.json` (each with its source and hash).
    pub fn plan(&mut self, plan: &Plan) -> Result<(), CaptureError> {
        let passes: Vec<Value> = plan
            .passes()
            .iter()
            .map(|pass| {
                json!({
                    "recording": pass.recording.label(),
                    "stage": pass.stage,
                    "variant": pass.module.name,
                    "count": pass.count,
                })
            })
            .collect();
        let modules: BTreeMap<&str, Value> = plan
            .passes()
            .iter()
            .map(|pass| {
                let module = pass.module;
                let about = json!({ "source": module.source, "hash": module.hash, "group_size": module.group_size });
                (module.name, about)
            })
            .collect();
        let plan = json!({ "passes": passes, "bytes": plan.bytes() }).to_string();
        self.attach("plan.json", "application/json", plan.as_bytes())?;
        self.attach("shaders.json", "application/json", json!(modules).to_string().as_bytes())
    }

    /// Records what capturing costs as metadata `capture_cost`.
    pub fn cost(&mut self, cost: &CaptureCost) -> Result<(), CaptureError> {
        self.metadata("capture_cost", cost.fields())
    }

    /// Records facts that hold for the whole run as metadata `name`.
    pub fn metadata<K: Into<String>>(
        &mut self,
        name: &str,
        fields: impl IntoIterator<Item = (K, String)>,
    ) -> Result<(), CaptureError> {
        let record = record(name, fields);
        self.timed(|this| {
            this.write(|writer| writer.write_metadata(&record))?;
            this.write_chunk()
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
            this.write(|writer| writer.attach(&attachment))?;
            this.write_chunk()
        })
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
        self.timed(|this| {
            this.message(channel, wall_ns, &row)?;
            this.flush_when_due()
        })
    }

    /// Writes what was collected as a chunk, now.
    pub fn flush(&mut self) -> Result<(), CaptureError> {
        self.timed(Self::write_chunk)
    }

    fn write_chunk(&mut self) -> Result<(), CaptureError> {
        self.last_flush = Instant::now();
        self.chunk_begin = self.bytes;
        self.sequences.forget();
        self.write(|writer| writer.flush())
    }

    /// Writes the last chunk, what was counted, and the file's summary section.
    pub fn finish(mut self) -> Result<CaptureTotals, CaptureError> {
        self.trust.log_times_raised = self.clock.raised;
        let trust = self.trust;
        if let Some(ticks) = self.tie.fields(self.clock.start_ns) {
            self.metadata("ticks", ticks)?;
        }
        self.metadata("trust", trust.fields())?;
        self.timed(|this| this.write(|writer| writer.finish().map(|_| ())))?;
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
            trust,
        })
    }

    pub(crate) fn flush_when_due(&mut self) -> Result<(), CaptureError> {
        let is_due = self.last_flush.elapsed() >= self.flush_every || self.bytes - self.chunk_begin >= CHUNK_BYTES;
        if is_due { self.write_chunk() } else { Ok(()) }
    }

    /// Runs `job`, a call from outside, and counts its time as the capture's.
    pub(crate) fn timed<T>(&mut self, job: impl FnOnce(&mut Self) -> T) -> T {
        self.call_begun = Instant::now();
        let result = job(self);
        self.spent += self.call_begun.elapsed();
        result
    }

    /// Processor time of capturing since the last call of this, within the call that runs.
    pub(crate) fn spent_since_frame(&mut self) -> Duration {
        let spent = self.spent + self.call_begun.elapsed();
        let since = spent - self.spent_reported;
        self.spent_reported = spent;
        since
    }

    /// Unix time of a moment of the capture clock, ns.
    pub(crate) fn unix_ns(&self, wall_ns: u64) -> u64 {
        self.clock.start_ns.saturating_add(wall_ns)
    }

    /// Runs `job` on the open file; the first failure closes it. Nothing to do on a closed one.
    fn write(&mut self, job: impl FnOnce(&mut Writer<Sink<W>>) -> mcap::McapResult<()>) -> Result<(), CaptureError> {
        let Some(writer) = &mut self.writer else {
            return Ok(());
        };
        job(writer).map_err(|source| {
            self.writer = None;
            CaptureError::write(&self.name, self.frames, source)
        })
    }

    /// Writes a message of JSON.
    pub(crate) fn message(&mut self, channel: u16, wall_ns: u64, row: &impl Serialize) -> Result<(), CaptureError> {
        let mut failed = None;
        self.bytes(channel, wall_ns, |buffer| failed = serde_json::to_writer(buffer, row).err())?;
        // No row of ours has a key that is no text, the one thing that cannot be JSON.
        failed.map_or(Ok(()), |error| {
            Err(CaptureError::write(&self.name, self.frames, std::io::Error::from(error).into()))
        })
    }

    /// Writes the message that `make` appends to a buffer.
    pub(crate) fn bytes(
        &mut self,
        channel_id: u16,
        wall_ns: u64,
        make: impl FnOnce(&mut Vec<u8>),
    ) -> Result<(), CaptureError> {
        if self.is_broken() {
            return Ok(());
        }
        let (log_time, publish_time) = self.clock.times(wall_ns);
        let header = MessageHeader { channel_id, sequence: self.sequence, log_time, publish_time };
        let mut buffer = std::mem::take(&mut self.buffer);
        buffer.clear();
        make(&mut buffer);
        self.sequence = self.sequence.wrapping_add(1);
        self.messages += 1;
        self.bytes += buffer.len() as u64;
        let written = self.write(|writer| writer.write_to_known_channel(&header, &buffer));
        self.buffer = buffer;
        written
    }

    /// A channel of JSON messages.
    pub(crate) fn declare(&mut self, topic: &str, name: &str, schema: &Value) -> Result<u16, CaptureError> {
        let mut id = 0;
        self.write(|writer| {
            id = add_channel(writer, topic, name, schema)?;
            Ok(())
        })?;
        Ok(id)
    }

    /// A channel of protobuf messages, of a schema's name and descriptors.
    pub(crate) fn declare_protobuf(&mut self, topic: &str, schema: (&str, Vec<u8>)) -> Result<u16, CaptureError> {
        let mut id = 0;
        self.write(|writer| {
            let schema_id = writer.add_schema(schema.0, "protobuf", &schema.1)?;
            id = writer.add_channel(schema_id, topic, "protobuf", &version())?;
            Ok(())
        })?;
        Ok(id)
    }

    /// A new channel of `/gpu/passes`, for stages that came.
    pub(crate) fn declare_passes(&mut self) -> Result<(), CaptureError> {
        let schema = passes_schema(self.stages.names());
        self.channels.passes = self.declare(PASSES_TOPIC, "brooklet.Passes", &schema)?;
        Ok(())
    }
}

fn record<K: Into<String>>(name: &str, fields: impl IntoIterator<Item = (K, String)>) -> Metadata {
    Metadata { name: name.into(), metadata: fields.into_iter().map(|(key, value)| (key.into(), value)).collect() }
}

fn version() -> BTreeMap<String, String> {
    BTreeMap::from([(FORMAT_KEY.into(), FORMAT_VERSION.into())])
}

fn add_channel<W: Write>(
    writer: &mut Writer<Sink<W>>,
    topic: &str,
    name: &str,
    schema: &Value,
) -> mcap::McapResult<u16> {
    let text = serde_json::to_vec(schema).map_err(std::io::Error::from)?;
    let schema_id = writer.add_schema(name, "jsonschema", &text)?;
    writer.add_channel(schema_id, topic, "json", &version())
}

fn add_channels<W: Write>(
    writer: &mut Writer<Sink<W>>,
    stages: &Stages,
    stats: &[StatField],
) -> mcap::McapResult<Channels> {
    let mut add = |topic: &str, name: &str, schema: &Value| add_channel(writer, topic, name, schema);
    Ok(Channels {
        frame: add(FRAME_TOPIC, "brooklet.Frame", &frame_schema())?,
        passes: add(PASSES_TOPIC, "brooklet.Passes", &passes_schema(stages.names()))?,
        span: add(SPAN_TOPIC, "brooklet.Spans", &span_schema())?,
        stats: if stats.is_empty() { None } else { Some(add(STATS_TOPIC, "brooklet.Stats", &stats_schema(stats))?) },
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
