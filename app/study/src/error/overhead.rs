//! What watching costs: the same steps plain, with GPU timestamps, with a capture, and with measurements,
//! in turns, by the host's clock. Ratios within a round are of the same minute and the same machine.

use std::time::{Instant, SystemTime};

use brooklet_capture::{CaptureOptions, CaptureWriter};
use brooklet_fluid::{self as fluid, FrameRequest, ParticleSource, Scene, SessionRecorder, SessionReport};
use brooklet_gpu::{Gpu, Quantiles};

use super::OVERHEAD_PART;
use crate::session::{Session, StudyError};
use crate::{Figure, Outcome, State, Task};

/// Steps of a block.
const STEPS: u32 = 24;
/// Steps between two measurements, as scenes have it by default.
const MEASURE_EVERY: u32 = 4;

/// One task: the shipped dam break, coarse enough that a step is short and its overhead is not small.
pub fn overhead_tasks(quick: bool) -> Vec<Task> {
    let rounds = if quick { 3 } else { 25 };
    vec![Task {
        part: OVERHEAD_PART.into(),
        case: "dam-break".into(),
        settings: vec!["spacing_m=0.04".into()],
        tier: "desktop".into(),
        repeats: rounds,
    }]
}

/// An engine with the scene in it.
struct Bench {
    session: fluid::Session,
    capture: Option<CaptureWriter<std::fs::File>>,
}

impl Bench {
    fn new(gpu: &Gpu, scene: &Scene, captured: bool) -> Result<Self, String> {
        let planned = SessionRecorder::new(scene, ParticleSource::Scene).sweep().map_err(|e| e.to_string())?;
        let stages = planned.plan.passes().iter().map(|pass| pass.stage.to_string()).collect();
        let options = CaptureOptions { stages, start: SystemTime::now(), ..CaptureOptions::default() };
        let open = || -> Result<_, String> {
            let file = tempfile::tempfile().map_err(|e| e.to_string())?;
            CaptureWriter::new(file, "overhead".into(), options).map_err(|e| e.to_string())
        };
        let capture = captured.then(open).transpose()?;
        let mut session = fluid::Session::start(gpu, planned).map_err(|e| e.to_string())?;
        session.finish().map_err(|e| e.to_string())?;
        Ok(Self { session, capture })
    }

    /// Seconds of a block.
    fn block(&mut self, measures: bool) -> Result<f64, String> {
        let begun = Instant::now();
        for step in 0..STEPS {
            let with = measures && step % MEASURE_EVERY == 0;
            let request = FrameRequest { steps: 1, measure: with, ..FrameRequest::default() };
            self.session.submit(&request).map_err(|e| e.to_string())?;
            let reports = self.session.reports();
            self.keep(&reports)?;
        }
        let reports = self.session.finish().map_err(|e| e.to_string())?;
        self.keep(&reports)?;
        Ok(begun.elapsed().as_secs_f64())
    }

    fn keep(&mut self, reports: &[SessionReport]) -> Result<(), String> {
        let Some(capture) = &mut self.capture else { return Ok(()) };
        reports.iter().try_for_each(|frame| capture.frame(&frame.report)).map_err(|e| e.to_string())
    }
}

/// Runs it; none if it was stopped.
///
/// # Errors
/// If the device is not there.
pub fn run_overhead(session: &Session<'_>, task: &Task) -> Result<Option<Outcome>, StudyError> {
    let (timed, plain) = (session.gpu(&task.tier)?, session.gpu_without_times(&task.tier)?);
    let mut rounds: Vec<[f64; 4]> = Vec::new();
    let mut go = || -> Result<bool, String> {
        let scene = Scene::load(&task.case, &task.settings).map_err(|e| e.to_string())?;
        let mut ways = [
            (Bench::new(&plain, &scene, false)?, false),
            (Bench::new(&timed, &scene, false)?, false),
            (Bench::new(&timed, &scene, true)?, false),
            (Bench::new(&timed, &scene, true)?, true),
        ];
        // The first round warms up.
        for round in 0..=task.repeats {
            if session.stops() {
                return Ok(false);
            }
            let mut seconds = [0.0; 4];
            for ((bench, measures), seconds) in ways.iter_mut().zip(&mut seconds) {
                *seconds = bench.block(*measures)?;
            }
            if round > 0 {
                rounds.push(seconds);
            }
        }
        Ok(true)
    };
    match go() {
        Ok(true) => {}
        Ok(false) => return Ok(None),
        Err(reason) => return Ok(Some(Outcome::empty(State::Refused, reason))),
    }
    let ratio = |way: usize, to: usize| median(rounds.iter().map(|round| round[way] / round[to]).collect()) - 1.0;
    let mut outcome = Outcome::empty(State::Stable, "");
    outcome.figures = vec![
        Figure::told("timestamps", ratio(1, 0), "", "of a step: with them over without, median of the rounds"),
        Figure::told("capture", ratio(2, 1), "", "of a step: writing every frame to a capture, over not"),
        Figure::told("measuring", ratio(3, 2), "", "of a step: a measurement every fourth, over none"),
        Figure::told(
            "step",
            1e3 * median(rounds.iter().map(|round| round[0] / f64::from(STEPS)).collect()),
            "ms",
            "plain",
        ),
    ];
    outcome.device = timed.info().name.clone();
    Ok(Some(outcome))
}

fn median(values: Vec<f64>) -> f64 {
    Quantiles::of(values).map_or(f64::NAN, |quantiles| quantiles.median)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians() {
        assert_eq!((median(vec![3.0, 1.0, 2.0]), median(vec![4.0, 1.0, 2.0, 3.0])), (2.0, 2.5));
        assert!(median(Vec::new()).is_nan());
    }
}
