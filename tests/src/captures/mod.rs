//! SetupResult-up frame reports, and a reading of MCAP's framing that shares no code with the crate.

pub mod events;
pub mod python;

use std::collections::BTreeSet;

use brooklet_capture::Capture;
use brooklet_gpu::{FrameReport, RecordingId, Span, SpanFlag, TimingStatus};

/// Opcode of a chunk.
pub const CHUNK: u8 = 0x06;
const MESSAGE: u8 = 0x05;

/// A record of the file and where it ends.
pub struct Record {
    /// What it is.
    pub opcode: u8,
    /// Position of the first byte behind it.
    pub end: usize,
    /// Messages in it, if it is a chunk.
    pub messages: usize,
}

/// The complete records of an MCAP file, by the format's description: an opcode, a length of 8
/// bytes, and that many bytes. A record that is cut off is left out.
pub fn records(bytes: &[u8]) -> Vec<Record> {
    let mut records = Vec::new();
    let mut at = mcap::MAGIC.len();
    while let Some((opcode, end)) = framing(bytes, at) {
        let body = &bytes[at + 9..end];
        let messages = if opcode == CHUNK { chunk_messages(body) } else { 0 };
        records.push(Record { opcode, end, messages });
        at = end;
    }
    records
}

/// The record at `at`: its opcode, and where it ends.
pub fn framing(bytes: &[u8], at: usize) -> Option<(u8, usize)> {
    let head = bytes.get(at..at + 9)?;
    let length = u64::from_le_bytes(head[1..].try_into().ok()?);
    let end = at.checked_add(9)?.checked_add(usize::try_from(length).ok()?)?;
    (end <= bytes.len()).then_some((head[0], end))
}

/// Messages in an uncompressed chunk: start, end and size (8 bytes each), checksum (4), the
/// compression's name (4 + its length), the length of the records (8), the records.
fn chunk_messages(body: &[u8]) -> usize {
    assert_eq!(body[28..32], [0; 4], "a compressed chunk");
    let records = &body[40..];
    let (mut at, mut messages) = (0, 0);
    while let Some((opcode, end)) = framing(records, at) {
        messages += usize::from(opcode == MESSAGE);
        at = end;
    }
    assert_eq!(at, records.len(), "a record that does not fit its chunk");
    messages
}

/// Messages that were read: a frame's spans are one.
pub fn messages(capture: &Capture) -> usize {
    let with_spans: BTreeSet<u64> = capture.spans.iter().map(|span| span.frame).collect();
    let lists = [capture.frames.len(), capture.passes.len(), capture.stats.len(), capture.states.len()];
    lists.iter().sum::<usize>() + capture.thermal.len() + with_spans.len()
}

/// A frame of three passes in two stages; the last one of frame 2 took no time at all.
pub fn frame_report(frame: u64) -> FrameReport {
    // Beyond 2^53, where a double no longer tells two ticks apart.
    let begin = 1 << 60 | frame << 20 | 1;
    let span = |stage, offset, ticks, flag| Span {
        recording: RecordingId::outside("step"),
        stage,
        begin_ticks: begin + offset,
        end_ticks: begin + offset + ticks,
        flag,
    };
    let (ticks, flag) = match frame {
        2 => (0, SpanFlag::Zero),
        _ => (700 + frame, SpanFlag::Ok),
    };
    FrameReport {
        frame,
        wall_ns: 16_666_667 * frame,
        spans: vec![
            span("count_cells", 0, 1000, SpanFlag::Ok),
            span("scan_groups", 1200, 500 + frame, SpanFlag::Ok),
            span("scan_groups", 2000, ticks, flag),
        ],
        dropped_spans: 0,
        readbacks: Vec::new(),
        timing: TimingStatus::InsidePasses,
        timestamp_period_ns: 52.0,
    }
}

/// Where the chunks of a file begin.
pub fn chunk_starts(bytes: &[u8]) -> Vec<usize> {
    let mut starts = Vec::new();
    let mut at = mcap::MAGIC.len();
    while let Some((opcode, end)) = framing(bytes, at) {
        starts.extend((opcode == CHUNK).then_some(at));
        at = end;
    }
    starts
}
