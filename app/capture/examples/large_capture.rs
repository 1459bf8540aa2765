//! Writes a large capture of made-up frames, to time readers on: 40 passes a frame, 60 frames a second.
//!
//!     cargo run --release -p brooklet-capture --example large_capture -- large.mcap 1000

use std::error::Error;

use brooklet_capture::{CaptureOptions, CaptureWriter, StateRow};
use brooklet_gpu::{FrameReport, RecordingId, Span, SpanFlag, TimingStatus};

const PASSES: usize = 40;
const FRAME_NS: u64 = 16_666_667;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().unwrap_or("large.mcap".into());
    let bytes = arguments.next().map_or(Ok(1000), |text| text.parse::<u64>())? * 1_000_000;
    let stages: Vec<&'static str> =
        (0..PASSES).map(|pass| &*Box::leak(format!("stage_number_{pass:02}").into_boxed_str())).collect();
    let mut random = fastrand::Rng::with_seed(1);
    let mut capture = CaptureWriter::create(path.as_ref(), CaptureOptions::default())?;
    let mut frame = 0;
    while capture.bytes_written() < bytes {
        let begin = 1_234_567_890_123 + frame * FRAME_NS;
        let mut at = begin;
        let spans = stages.iter().map(|stage| {
            let begin_ticks = at + random.u64(0..2000);
            at = begin_ticks + 300_000 + random.u64(0..60_000);
            Span { recording: RecordingId::outside("step"), stage, begin_ticks, end_ticks: at, flag: SpanFlag::Ok }
        });
        capture.frame(&FrameReport {
            frame,
            wall_ns: frame * FRAME_NS,
            spans: spans.collect(),
            dropped_spans: 0,
            readbacks: Vec::new(),
            timing: TimingStatus::InsidePasses,
            timestamp_period_ns: 1.0,
        })?;
        if frame % 600 == 0 {
            capture.state(frame * FRAME_NS, &StateRow { event: "still running".into(), ..StateRow::default() })?;
        }
        frame += 1;
    }
    let totals = capture.finish()?;
    let us = 1e3 * totals.capture_ms / totals.frames as f64;
    println!("{path}: {} frames, {us:.1} us of the processor a frame", totals.frames);
    Ok(())
}
