//! GPU pass timings and named statistics, to and from [MCAP](https://mcap.dev) files.
//!
//! This crate knows no fluids: it takes the timing reports of `brooklet-gpu` and whatever
//! statistics the caller names, so any program that runs on that engine can record itself.
//!
//! | topic | one message per | fields |
//! |---|---|---|
//! | `/gpu/frame` | frame | `frame`, `wall_s`, `gpu_ms`, `pass_sum_ms`, `timing`, `spans`, `flagged_spans`, `capture_ms` |
//! | `/gpu/passes` | frame | one `<stage>_ms` per stage, its dispatches summed |
//! | `/gpu/span` | dispatch | `recording`, `stage`, raw `begin_ticks` and `end_ticks`, `flag` |
//! | `/sim/stats` | measurement | the caller's named statistics |
//!
//! Messages are flat JSON with a JSON Schema, which plotting tools read as they are. What is
//! constant over a run (device, driver, limits, build) is in metadata records, and whole files
//! (the scene) are attachments.
//!
//! A capture is only ever appended to, one whole chunk at a time, about once a second. So a
//! program that is killed, or a disk that runs full, leaves a file whose complete chunks
//! [`Capture::open`] reads.

mod error;
mod framing;
mod reader;
mod rows;
mod schema;
mod sink;
mod writer;

pub use error::CaptureError;
pub use reader::{Attachment, Capture};
pub use rows::{FrameRow, PassRow, SpanRow, StatsRow};
pub use schema::{
    FRAME_TOPIC, PASSES_TOPIC, SPAN_TOPIC, STATS_TOPIC, StatField, frame_schema, passes_schema, span_schema,
    stats_schema,
};
pub use writer::{CaptureOptions, CaptureTotals, CaptureWriter};
