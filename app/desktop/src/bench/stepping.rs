//! Runs a recording again and again, and keeps its times.

use std::time::Instant;

use brooklet_gpu::{Engine, RecordingId, ResourceId};

use crate::{failure::Failure, interrupt::Interrupt, timings::Timings};

/// What is run, and how it is stopped.
pub struct Stepping<'a> {
    /// What runs it.
    pub engine: &'a mut Engine,
    /// A frame's recordings, that of a step first.
    pub recordings: &'a [RecordingId],
    /// What a frame reads back.
    pub readbacks: &'a [ResourceId],
    /// Ctrl-C.
    pub interrupt: &'a Interrupt,
}

impl Stepping<'_> {
    /// Runs `frames` frames to their end, and returns how many seconds one took.
    pub fn run(&mut self, frames: u64, timings: &mut Timings, mut each: impl FnMut()) -> Result<f64, Failure> {
        let begun = Instant::now();
        let Some(&step) = self.recordings.first() else { return Ok(0.0) };
        for _ in 0..frames {
            if self.interrupt.is_pressed() {
                return Err(Failure::Interrupted("nothing was written".into()));
            }
            self.engine.run(self.recordings, self.readbacks).map_err(Failure::stopped)?;
            for report in self.engine.reports() {
                timings.add(&report, step);
            }
            each();
        }
        for report in self.engine.finish().map_err(Failure::stopped)? {
            timings.add(&report, step);
        }
        Ok(begun.elapsed().as_secs_f64() / frames.max(1) as f64)
    }
}
