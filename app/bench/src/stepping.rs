//! Runs frames again and again, and keeps their times.

use std::time::Instant;

use brooklet_fluid::{FrameRequest, Scene, Session, SessionReport};
use brooklet_gpu::{Gpu, Timings};

use crate::{BenchError, Observer, workload};

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

/// A scene that was stepped as long as there was time.
pub struct Paced {
    /// What ran it, all done.
    pub session: Session,
    /// Of the steps behind the warm-up.
    pub timings: Timings,
    /// So many.
    pub steps: u64,
    /// What one took before they were counted, s.
    pub step_s: f64,
}

/// Frames before the pace is taken, and again while it is.
const WARM_UP: u64 = 2;
/// Fewer make no median.
const MIN_STEPS: u64 = 5;
/// More tell nothing new.
const MAX_STEPS: u64 = 60;
/// What [`pace`] runs at least.
pub const LEAST_STEPS: u64 = MIN_STEPS + 2 * WARM_UP;

/// Steps a block of the workload's for about `share_s` seconds, its particles off the lattice.
pub fn pace(
    gpu: &Gpu,
    scene: &Scene,
    measure: bool,
    share_s: f64,
    observer: &dyn Observer,
) -> Result<Paced, BenchError> {
    let begun = Instant::now();
    let planned = workload::plan(scene)?;
    let mut session = brooklet_render::start(gpu, planned).map_err(BenchError::input)?;
    session.finish().map_err(BenchError::stopped)?;
    let mut timings = Timings::new(2 * WARM_UP);
    let request = FrameRequest { steps: 1, measure, ..FrameRequest::default() };
    let mut stepping = Stepping { session: &mut session, request, observer };
    // The first steps also sort particles for the first time: they tell nothing of the pace.
    stepping.run(WARM_UP, &mut timings, || ())?;
    let step_s = stepping.run(WARM_UP, &mut timings, || ())?;
    let left_s = share_s - begun.elapsed().as_secs_f64();
    let steps = ((left_s / step_s) as u64).clamp(MIN_STEPS, MAX_STEPS);
    stepping.run(steps, &mut timings, || ())?;
    Ok(Paced { session, timings, steps, step_s })
}
