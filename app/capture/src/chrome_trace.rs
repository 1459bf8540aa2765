//! A capture as a Chrome trace (JSON), which Perfetto and `chrome://tracing` open: frames with their passes
//! inside, statistics as counters, changes and lines of the log as marks.

use std::{io::Write, path::Path};

use serde_json::{Map, Value, json};

use crate::{
    CaptureError, Item, LOG_TOPIC, Message, SPAN_TOPIC, STATE_TOPIC, STATS_TOPIC, THERMAL_TOPIC,
    spans::SpanReader,
    stream::{message_problem, read_file},
};

/// Thread of the frames and passes, and that of marks.
const GPU: u32 = 1;
const MARKS: u32 = 2;

struct Trace<W> {
    to: W,
    is_first: bool,
    sequences: SpanReader,
    period_ns: f64,
    /// The first tick, and its moment in µs of the trace.
    base: Option<(u64, f64)>,
    /// Unix ns that is 0 in the trace.
    zero_ns: Option<u64>,
    events: u64,
}

/// Writes the trace; returns the number of events.
///
/// # Errors
/// If `path` cannot be read or is no capture of this version, or if writing fails.
pub fn chrome_trace(path: &Path, to: impl Write, to_name: &str) -> Result<u64, CaptureError> {
    let name = path.display().to_string();
    let mut trace = Trace {
        to,
        is_first: true,
        sequences: SpanReader::default(),
        period_ns: 1.0,
        base: None,
        zero_ns: None,
        events: 0,
    };
    let failed = |source| CaptureError::Io { name: to_name.into(), action: "write", source };
    trace.begin().map_err(failed)?;
    // It stands at the end of the file, or in the facts of the device.
    read_file(path, &mut |item| {
        if let Item::Metadata("device" | "ticks", fields) = item {
            let period = fields.get("timestamp_period_ns").and_then(|text| text.parse().ok());
            trace.period_ns = period.unwrap_or(trace.period_ns);
        }
        Ok(())
    })?;
    read_file(path, &mut |item| match item {
        Item::Message(message) => match trace.message(message) {
            Ok(()) => Ok(()),
            Err(Failed::Write(error)) => Err(failed(error)),
            Err(Failed::Message(problem)) => Err(message_problem(&name, &message.channel.topic, 0, &problem)),
        },
        _ => Ok(()),
    })?;
    trace.to.write_all(b"\n]}\n").and_then(|()| trace.to.flush()).map_err(failed)?;
    Ok(trace.events)
}

enum Failed {
    Write(std::io::Error),
    Message(String),
}

impl From<std::io::Error> for Failed {
    fn from(error: std::io::Error) -> Self {
        Self::Write(error)
    }
}

impl From<serde_json::Error> for Failed {
    fn from(error: serde_json::Error) -> Self {
        Self::Message(error.to_string())
    }
}

impl<W: Write> Trace<W> {
    fn begin(&mut self) -> std::io::Result<()> {
        self.to.write_all(b"{\"displayTimeUnit\":\"ms\",\"traceEvents\":[")?;
        for (thread, name) in [(GPU, "GPU"), (MARKS, "states and log")] {
            self.event(json!({ "name": "thread_name", "ph": "M", "pid": 1, "tid": thread, "args": { "name": name } }))?;
        }
        Ok(())
    }

    fn event(&mut self, event: Value) -> std::io::Result<()> {
        self.to.write_all(if std::mem::replace(&mut self.is_first, false) { b"\n" } else { b",\n" })?;
        self.events += 1;
        serde_json::to_writer(&mut self.to, &event).map_err(std::io::Error::from)
    }

    fn message(&mut self, message: Message<'_>) -> Result<(), Failed> {
        let zero_ns = *self.zero_ns.get_or_insert(message.publish_time);
        let at_us = (message.publish_time as i128 - i128::from(zero_ns)) as f64 * 1e-3;
        match message.channel.topic.as_str() {
            SPAN_TOPIC => self.spans(message.data, at_us),
            STATS_TOPIC | THERMAL_TOPIC => {
                let row: Map<String, Value> = serde_json::from_slice(message.data)?;
                let of = message.channel.topic.trim_start_matches('/');
                for (key, value) in
                    row.into_iter().filter(|(key, value)| value.is_number() && key != "frame" && key != "wall_s")
                {
                    let event = json!({
                        "name": format!("{of} {key}"), "ph": "C", "pid": 1, "ts": at_us, "args": { "value": value },
                    });
                    self.event(event)?;
                }
                Ok(())
            }
            STATE_TOPIC => {
                let row: Map<String, Value> = serde_json::from_slice(message.data)?;
                let name = row.get("event").cloned().unwrap_or_default();
                self.mark(name, at_us, Value::Object(row.clone()))?;
                let rung = json!({
                    "name": "rung", "ph": "C", "pid": 1, "ts": at_us, "args": { "value": row.get("rung") },
                });
                Ok(self.event(rung)?)
            }
            LOG_TOPIC => {
                let row: Map<String, Value> = serde_json::from_slice(message.data)?;
                let name = row.get("message").cloned().unwrap_or_default();
                Ok(self.mark(name, at_us, json!({ "level": row.get("level") }))?)
            }
            _ => Ok(()),
        }
    }

    fn mark(&mut self, name: Value, at_us: f64, about: Value) -> std::io::Result<()> {
        self.event(json!({ "name": name, "ph": "i", "s": "p", "pid": 1, "tid": MARKS, "ts": at_us, "args": about }))
    }

    /// A frame and its passes, by their ticks; the first frame's begin is put to its submission.
    fn spans(&mut self, data: &[u8], at_us: f64) -> Result<(), Failed> {
        let rows = self.sequences.rows(data).map_err(Failed::Message)?;
        let Some(first) = rows.iter().map(|row| row.begin_ticks).min() else { return Ok(()) };
        let last = rows.iter().map(|row| row.end_ticks).max().unwrap_or(first);
        let (base, base_us) = *self.base.get_or_insert((first, at_us));
        let us = self.period_ns * 1e-3;
        let at = |ticks: u64| base_us + ticks.wrapping_sub(base) as i64 as f64 * us;
        let frame = rows[0].frame;
        self.event(json!({
            "name": format!("frame {frame}"), "cat": "frame", "ph": "X", "pid": 1, "tid": GPU,
            "ts": at(first), "dur": (last - first) as f64 * us, "args": { "frame": frame },
        }))?;
        for row in &rows {
            self.event(json!({
                "name": row.stage, "cat": row.recording, "ph": "X", "pid": 1, "tid": GPU,
                "ts": at(row.begin_ticks),
                "dur": row.end_ticks.saturating_sub(row.begin_ticks) as f64 * us,
                "args": { "begin_ticks": row.begin_ticks, "end_ticks": row.end_ticks, "flag": row.flag },
            }))?;
        }
        Ok(())
    }
}
