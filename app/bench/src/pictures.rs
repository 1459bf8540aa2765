//! What a picture costs, pass by pass.

use brooklet_fluid::{FrameRequest, Scene};
use brooklet_gpu::{Gpu, PassTimes, Passes, Quantiles, Timings, stages};
use serde::Serialize;

use crate::{
    BenchError, Observer,
    scene_options::{self, Options},
    stepping::Stepping,
    traffic::drawn_bytes,
};

/// Pictures before those that are timed.
const WARM_UP: u64 = 2;

/// A pass of a picture.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Pass {
    /// Its times.
    #[serde(flatten)]
    pub times: PassTimes,
    /// Its part in all passes' times.
    pub share: Option<f64>,
    /// What it binds and draws to, once each time it runs.
    pub bytes: u64,
}

/// The cost of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct PictureCost {
    /// Width and height, pixels.
    pub size_px: [u32; 2],
    /// How many were timed.
    pub pictures: u32,
    /// Where the scene leaves the surface's method to what is seen: the method it came to,
    pub chosen: Option<&'static str>,
    /// and the drawn pixels of fluid that it was chosen by.
    pub covered_px: Option<f64>,
    /// From the first pass's begin to the last one's end, ms.
    pub picture_ms: Option<Quantiles>,
    /// The part of the smoothing passes in all passes' times.
    pub smoothing_share: Option<f64>,
    /// Of everything that is there for pictures alone.
    pub bytes: u64,
    /// In order of their first run.
    pub passes: Passes<Pass>,
}

/// Draws the scene after `options`' steps, `options.pictures` times.
pub(crate) fn picture_cost(
    gpu: &Gpu,
    scene: &Scene,
    options: Options,
    observer: &dyn Observer,
) -> Result<Option<PictureCost>, BenchError> {
    if options.pictures == 0 {
        return Ok(None);
    }
    let mut scene = scene.clone();
    scene.outputs.images = 1;
    let planned = scene_options::plan(gpu, &scene)?;
    let (plan, recorded) = (planned.plan(), &planned.session.recorded);
    let total_bytes = plan.bytes() - plan.bytes_of(&[recorded.init.id(), recorded.step.id()]);
    let Some(mut passes) = planned.passes else { return Ok(None) };
    let mut session = brooklet_render::start(gpu, planned.session).map_err(BenchError::input)?;
    session.finish().map_err(BenchError::stopped)?;
    let steps = options.warm_up + options.steps;
    observer.begin(steps + WARM_UP + u64::from(options.pictures));
    let request = FrameRequest { steps: 1, ..FrameRequest::default() };
    let mut stepping = Stepping { session: &mut session, request, observer };
    stepping.run(steps, &mut Timings::new(0), || observer.advance())?;
    let mut timings = Timings::new(WARM_UP);
    let mut draw = passes.draw.id();
    for number in 0..WARM_UP + u64::from(options.pictures) {
        observer.check()?;
        if number < WARM_UP {
            // What is timed is drawn by the method that these come to.
            let particles = session.slot_count();
            draw = passes.next(session.engine_mut(), particles, false);
        }
        let readbacks: Vec<_> = passes.readbacks().collect();
        let request = FrameRequest { then: &[draw], readbacks: &readbacks, ..FrameRequest::default() };
        session.submit(&request).map_err(BenchError::stopped)?;
        for frame in session.finish().map_err(BenchError::stopped)? {
            passes.learn(&frame.report);
            timings.add(&frame.report, draw);
        }
        observer.advance();
    }
    let plan = session.engine().plan();
    let stages = stages(plan.passes().into_iter().filter(|pass| pass.recording == draw));
    let moved: Vec<u64> = stages.iter().map(|(stage, _)| drawn_bytes(plan, draw, stage)).collect();

    let median = |stage: &str| timings.stage_ms(stage).map(|times| times.median);
    let all_ms: f64 = stages.iter().filter_map(|(stage, _)| median(stage)).sum();
    let share_of = |ms: f64| (all_ms > 0.0).then(|| ms / all_ms);
    let is_smoothing = |stage: &str| stage.starts_with("draw_smooth_") && stage != "draw_smooth_sun_depth";
    let smoothing_ms: f64 = stages.iter().filter(|(s, _)| is_smoothing(s)).filter_map(|(s, _)| median(s)).sum();
    let pass = |(&(stage, dispatches), &bytes): (&(&'static str, u32), &u64)| {
        let share = median(stage).and_then(share_of);
        (stage, Pass { times: timings.pass(stage, dispatches), share, bytes })
    };
    Ok(Some(PictureCost {
        size_px: [scene.outputs.width_px, scene.outputs.height_px],
        pictures: options.pictures,
        chosen: passes.auto.as_ref().map(|auto| auto.shown().name()),
        covered_px: passes.auto.as_ref().map(|auto| auto.seen_px()),
        picture_ms: timings.step_ms(),
        smoothing_share: share_of(smoothing_ms),
        bytes: total_bytes,
        passes: Passes(stages.iter().zip(&moved).map(pass).collect()),
    }))
}
