//! Runs frames again and again, and keeps their times.

use std::time::Instant;

use brooklet_fluid::{FrameRequest, Session, SessionReport};
use brooklet_gpu::Timings;

use crate::{BenchError, Observer};

/// What is run, and how it is stopped.
pub struct Stepping<'a> {
    /// What runs it.
    pub session: &'a mut Session,
    /// What a frame does.
    pub request: FrameRequest<'a>,
    /// Ctrl-C.
    pub observer: &'a dyn Observer,
}

impl Stepping<'_> {
    /// Runs `frames` frames to their end, and returns how many seconds one took.
    pub fn run(&mut self, frames: u64, timings: &mut Timings, mut each: impl FnMut()) -> Result<f64, BenchError> {
        let step = self.session.step_id();
        let mut take = |reports: Vec<SessionReport>| reports.iter().for_each(|frame| timings.add(&frame.report, step));
        let begun = Instant::now();
        for _ in 0..frames {
            self.observer.check()?;
            self.session.submit(&self.request).map_err(BenchError::stopped)?;
            take(self.session.reports());
            each();
        }
        take(self.session.finish().map_err(BenchError::stopped)?);
        Ok(begun.elapsed().as_secs_f64() / frames.max(1) as f64)
    }
}
