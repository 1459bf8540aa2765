//! GPU pass timings and named statistics, to and from [MCAP](https://mcap.dev) files.
//!
//! This crate knows no fluids: it takes the timing reports of `brooklet-gpu` (an engine's, or those of
//! [`brooklet_gpu::PassTimer`], which times the passes of any wgpu program) and whatever statistics the
//! caller names. `CAPTURE.md` beside this crate has the format on a page; `examples/time_your_passes.rs`
//! is a whole program.
//!
//! | topic | one message per | fields |
//! |---|---|---|
//! | `/gpu/frame` | frame | `gpu_ms`, `pass_sum_ms`, `timing`, counts of spans, flags and drops, `capture_ms` |
//! | `/gpu/passes` | frame | one `<stage>_ms` per stage, its dispatches summed |
//! | `/gpu/span` | frame | raw ticks of each pass, flags |
//! | `/gpu/state` | change | tier, precision, surface, quality rung, paused, what changed |
//! | `/sim/stats` | measurement | the caller's named statistics |
//! | `/device/thermal` | second, where the system tells | temperatures, clocks, power |
//! | `/device/check` | case and kernel checked | verdict, difference and tolerance, what was got and expected |
//! | `/sim/particles` | when given | `foxglove.PointCloud` (protobuf) |
//! | `/view/image` | when given | `foxglove.CompressedImage` (protobuf) |
//! | `/log` | line | `foxglove.Log` |
//!
//! Messages but the two of protobuf are JSON with a JSON Schema, which plotting tools read as they are. What
//! is constant over a run (device, driver, limits, build, clocks) is in metadata records, and whole files
//! (scene, plan, shader manifest) are attachments.
//!
//! A capture is only ever appended to, one whole chunk at a time, about once a second. So a
//! program that is killed, or a disk that runs full, leaves a file whose complete chunks
//! [`Capture::open`] reads.

mod check;
mod chrome_trace;
mod clock;
mod compare;
mod cost;
mod device_state;
mod error;
mod events;
mod foxglove;
mod frames;
mod framing;
mod reader;
mod recover;
mod rows;
mod scan;
mod schema;
mod series;
mod sink;
mod spans;
mod statistics;
mod stream;
mod summary;
mod trust;
mod validate;
mod writer;

pub use check::{CheckReport, check};
pub use chrome_trace::chrome_trace;
pub use clock::CaptureClock;
pub use compare::{Comparison, Differences, FRAME, PassRatio, Times, Verdict};
pub use cost::CaptureCost;
pub use device_state::DeviceState;
pub use error::CaptureError;
pub use foxglove::Point;
pub use reader::{Attachment, Capture};
pub use recover::recover;
pub use rows::{CheckRow, FrameRow, Level, PassRow, SpanRow, StateRow, StatsRow, ThermalRow};
pub use schema::{
    CHECK_TOPIC, FORMAT_KEY, FORMAT_VERSION, FRAME_TOPIC, IMAGE_TOPIC, LOG_TOPIC, PARTICLES_TOPIC, PASSES_TOPIC,
    SPAN_TOPIC, STATE_TOPIC, STATS_TOPIC, StatField, THERMAL_TOPIC, TOPICS, check_schema, frame_schema, log_schema,
    passes_schema, span_schema, state_schema, stats_schema, thermal_schema,
};
pub use series::Quantiles;
pub use spans::SpanReader;
pub use stream::{Channel, Ending, Item, Message, read, read_file};
pub use summary::{CaptureSummary, Metadata, summarize};
pub use trust::Trust;
pub use writer::{CaptureOptions, CaptureTotals, CaptureWriter};
