//! What a picture costs, pass by pass.

use brooklet_fluid::{FrameRequest, Scene};
use brooklet_gpu::{Gpu, PassTimes, Passes, Quantiles, Timings, stages};
use serde::Serialize;

use super::{stepping::Stepping, traffic::drawn_bytes};
use crate::{
    bench_options::BenchOptions,
    failure::Failure,
    interrupt::Interrupt,
    job, progress,
    table::{bytes, ms, table},
};

/// Pictures before those that are timed.
const WARM_UP: u64 = 2;

/// A pass of a picture.
#[derive(Clone, Copy, Debug, Serialize)]
struct Pass {
    #[serde(flatten)]
    times: PassTimes,
    /// Its part in all passes' times.
    share: Option<f64>,
    /// What it binds and draws to, once each time it runs.
    bytes: u64,
}

/// The cost of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct PictureCost {
    size_px: [u32; 2],
    pictures: u32,
    /// From the first pass's begin to the last one's end, ms.
    picture_ms: Option<Quantiles>,
    /// The part of the smoothing passes in all passes' times.
    smoothing_share: Option<f64>,
    /// Of everything that is there for pictures alone.
    bytes: u64,
    passes: Passes<Pass>,
}

/// Draws the scene after `options`' steps, `options.pictures` times.
pub fn picture_cost(
    gpu: &Gpu,
    scene: &Scene,
    options: &BenchOptions,
    interrupt: &Interrupt,
) -> Result<Option<PictureCost>, Failure> {
    if options.pictures == 0 {
        return Ok(None);
    }
    let mut scene = scene.clone();
    scene.outputs.images = 1;
    let planned = job::plan(&scene, gpu.tier())?;
    let Some(draw) = planned.passes.as_ref().map(|passes| passes.draw.id()) else { return Ok(None) };
    let (plan, recorded) = (planned.plan(), &planned.session.recorded);
    let stages = stages(plan.passes().into_iter().filter(|pass| pass.recording == draw));
    let moved: Vec<u64> = stages.iter().map(|(stage, _)| drawn_bytes(plan, draw, stage)).collect();
    let total_bytes = plan.bytes() - plan.bytes_of(&[recorded.init.id(), recorded.step.id()]);
    let mut session = brooklet_render::start(gpu, planned.session).map_err(Failure::input)?;
    session.finish().map_err(Failure::stopped)?;
    let steps = options.warm_up + options.steps;
    let bar = progress::bar(steps + WARM_UP + u64::from(options.pictures));
    let request = FrameRequest { steps: 1, ..FrameRequest::default() };
    let mut stepping = Stepping { session: &mut session, request, interrupt };
    let outcome = stepping.run(steps, &mut Timings::new(0), || bar.inc(1));
    let mut timings = Timings::new(WARM_UP);
    let outcome = outcome.and_then(|_| {
        for _ in 0..WARM_UP + u64::from(options.pictures) {
            if interrupt.is_pressed() {
                return Err(Failure::Interrupted("nothing was written".into()));
            }
            let request = FrameRequest { then: &[draw], ..FrameRequest::default() };
            session.submit(&request).map_err(Failure::stopped)?;
            let reports = session.finish().map_err(Failure::stopped)?;
            reports.iter().for_each(|frame| timings.add(&frame.report, draw));
            bar.inc(1);
        }
        Ok(())
    });
    bar.finish_and_clear();
    outcome?;

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
        picture_ms: timings.step_ms(),
        smoothing_share: share_of(smoothing_ms),
        bytes: total_bytes,
        passes: Passes(stages.iter().zip(&moved).map(pass).collect()),
    }))
}

/// Prints the table.
pub fn print(cost: &PictureCost) {
    let [width, height] = cost.size_px;
    say!("\na picture of {width} x {height} pixels, {} drawn", cost.pictures);
    let mut list = table(&["pass", "median ms", "p95 ms", "share", "bytes", "runs"], &[1, 2, 3, 4, 5]);
    let percent = |share: Option<f64>| share.map_or_else(|| "-".into(), |share| format!("{:.1} %", 100.0 * share));
    for (stage, pass) in &cost.passes.0 {
        let times = pass.times;
        list.add_row([
            stage.to_string(),
            ms(times.median_ms),
            ms(times.p95_ms),
            percent(pass.share),
            bytes(pass.bytes),
            times.dispatches.to_string(),
        ]);
    }
    let picture = cost.picture_ms;
    let [median, p95] = [ms(picture.map(|t| t.median)), ms(picture.map(|t| t.p95))];
    list.add_row(["a picture, with gaps".into(), median, p95, String::new(), String::new(), String::new()]);
    say!("\n{}\n", list.trim_fmt());
    say!(
        "smoothing takes {} of the passes' time; pictures take {} of memory\n\
         (bytes: what a pass binds and draws to, once each time it runs; draws of one pass without a time of their\n\
         own are in that of the first)",
        percent(cost.smoothing_share),
        bytes(cost.bytes)
    );
}
