//! `brooklet run`: simulate, and write pictures, particles, a capture and a summary.

use std::{
    path::{Path, PathBuf},
    time::{Instant, SystemTime},
};

use brooklet_capture::{CaptureOptions, CaptureWriter};
use brooklet_fluid::{INIT, MEASURE, STEP, Scene};
use brooklet_gpu::{Engine, Gpu, ResourceId, tier_name};
use brooklet_kernels::{Buffer, Position, Velocity};
use brooklet_render::frame::{DRAW, DRAW_INIT};
use indicatif::ProgressBar;

use crate::{
    cli::RunOptions,
    commit::{COMMIT, VERSION},
    failure::Failure,
    interrupt::Interrupt,
    job::{self, Planned},
    left_out, measured, out_dir,
    pictures::Picture,
    ply, progress,
    recorder::Recorder,
    summary::{Facts, Files, Summary, stages},
    timings::{Timings, warm_up_frames},
};

/// Runs a scene.
pub fn run(options: &RunOptions) -> Result<(), Failure> {
    let scene = job::scene(&options.scene, Some(&options.outputs))?;
    let steps = job::steps(&scene, &options.length)?;
    let gpu = job::open(&options.device, !options.no_timing)?;
    let planned = job::plan(&scene, gpu.tier())?;
    let left_out = left_out::list(&scene, gpu.tier(), &planned.plan)?;
    let Planned { plan, particles, positions, velocities, measure, picture } = planned;
    let plan_bytes = plan.bytes();
    let stages = stages(&plan).into_iter().map(|(stage, _)| stage.into()).collect();
    let start = SystemTime::now();
    let mut engine = Engine::new(&gpu, plan.clone()).map_err(Failure::input)?;
    let interrupt = Interrupt::listen()?;

    let default_out = Path::new("out").join(&scene.name);
    let out = out_dir::create(options.out.as_deref().unwrap_or(&default_out))?;
    let capture_path = options.capture.clone().unwrap_or_else(|| out.join("capture.mcap"));
    let capture_options = CaptureOptions {
        stages,
        stats: if measure.is_some() { measured::fields() } else { Vec::new() },
        start,
        ..CaptureOptions::default()
    };
    let capture = open_capture(&capture_path, capture_options, &scene, &gpu)?;

    let timings = Timings::new(warm_up_frames(steps));
    let mut running = Running {
        recorder: Recorder::new(&scene, measure, timings, Some(capture)),
        scene: &scene,
        out: &out,
        steps,
        images: due_steps(steps, scene.outputs.images),
        positions,
        velocities,
        measure,
        picture,
        writes_particles: options.outputs.particles.is_some(),
        files: Files::default(),
    };
    let begun = Instant::now();
    let bar = progress::bar(steps);
    let outcome = running.all(&mut engine, &interrupt, &bar);
    bar.finish_and_clear();
    let wall_s = begun.elapsed().as_secs_f64();
    // Whatever ended the run: what is captured so far is closed properly.
    let totals = running.recorder.finish();
    let done = outcome?;

    let mut files = running.files;
    files.capture = Some(capture_path.display().to_string());
    files.capture_complete = totals.is_some_and(|totals| totals.complete);
    let summary_path = out.join("summary.json");
    files.summary = summary_path.display().to_string();
    let interrupted = done < steps;
    let summary = Summary::new(Facts {
        scene: &scene,
        plan: &plan,
        particles,
        steps: done,
        wall_s,
        interrupted,
        timings: &running.recorder.timings,
        measured: &running.recorder.measured,
        left_out,
        gpu: &gpu,
        files: files.clone(),
    });
    let json = summary.to_json().map_err(Failure::stopped)?;
    out_dir::write_file(&summary_path, json.as_bytes())?;
    if options.json {
        println!("{json}");
    } else {
        summary.print(plan_bytes);
        print_files(&files);
    }
    if let Some(trouble) = running.recorder.trouble {
        return Err(Failure::stopped(trouble));
    }
    if interrupted {
        return Err(Failure::Interrupted(format!("{done} of {steps} steps are in {}", out.display())));
    }
    Ok(())
}

/// Steps at whose end one of `count` pictures is due: spread evenly, the last at the end. A run
/// of fewer steps has a picture after each.
fn due_steps(steps: u64, count: u32) -> Vec<u64> {
    let count = u64::from(count).min(steps);
    (1..=count).map(|number| (u128::from(number) * u128::from(steps) / u128::from(count)) as u64).collect()
}

fn open_capture(
    path: &Path,
    options: CaptureOptions,
    scene: &Scene,
    gpu: &Gpu,
) -> Result<CaptureWriter<std::fs::File>, Failure> {
    let write = || {
        let mut capture = CaptureWriter::create(path, options)?;
        capture.device(gpu.info(), tier_name(gpu.tier()))?;
        let build = [("program", "brooklet"), ("version", VERSION), ("commit", COMMIT)];
        capture.metadata("build", build.map(|(key, value)| (key, value.to_string())))?;
        let name = format!("{}.toml", scene.name);
        capture.attach(&name, "application/toml", scene.to_toml().as_bytes())?;
        Ok(capture)
    };
    write().map_err(|error: brooklet_capture::CaptureError| Failure::input(error))
}

fn print_files(files: &Files) {
    println!();
    match files.images.as_slice() {
        [] => {}
        [only] => println!("picture   {only}"),
        [first, .., last] => {
            println!("pictures  {first} to {last} ({})", files.images.len());
        }
    }
    match files.particles.as_slice() {
        [] => {}
        [only] => println!("particles {only}"),
        [first, .., last] => {
            println!("particles {first} to {last} ({})", files.particles.len());
        }
    }
    if let Some(capture) = &files.capture {
        let note = if files.capture_complete { "" } else { " (incomplete)" };
        println!("capture   {capture}{note}");
    }
    println!("summary   {}", files.summary);
}

/// A run under way.
struct Running<'a> {
    recorder: Recorder,
    scene: &'a Scene,
    out: &'a Path,
    steps: u64,
    /// Steps at whose end a picture is due, in order.
    images: Vec<u64>,
    positions: Buffer<Position>,
    velocities: Buffer<Velocity>,
    measure: Option<ResourceId>,
    picture: Option<Picture>,
    writes_particles: bool,
    files: Files,
}

impl Running<'_> {
    /// All steps, or those before Ctrl-C; returns how many were done.
    fn all(&mut self, engine: &mut Engine, interrupt: &Interrupt, bar: &ProgressBar) -> Result<u64, Failure> {
        engine.run(&[INIT], &[]).map_err(Failure::stopped)?;
        if self.picture.is_some() {
            engine.run(&[DRAW_INIT], &[]).map_err(Failure::stopped)?;
        }
        let mut done = 0;
        while done < self.steps && !interrupt.is_pressed() {
            done += 1;
            self.step(engine, done)?;
            bar.inc(1);
            if let Some(stats) = self.recorder.measured.last {
                bar.set_message(format!("density error {:.2} %", 100.0 * stats.density_error.mean));
            }
        }
        let reports = engine.finish().map_err(Failure::stopped)?;
        self.recorder.take(&reports);
        Ok(done)
    }

    /// Step number `step`, from 1, with what is due at its end.
    fn step(&mut self, engine: &mut Engine, step: u64) -> Result<(), Failure> {
        let is_last = step == self.steps;
        let every = u64::from(self.scene.outputs.measure_every_steps);
        let measures = every > 0 && (is_last || step.is_multiple_of(every));
        let image = self.images.binary_search(&step).ok();

        let mut recordings = vec![STEP];
        let mut readbacks = Vec::new();
        if measures {
            recordings.push(MEASURE);
            readbacks.extend(self.measure);
        }
        if image.is_some() && self.picture.is_some() {
            recordings.push(DRAW);
        }
        let frame = engine.run(&recordings, &readbacks).map_err(Failure::stopped)?;
        self.recorder.expect(frame, step);
        self.recorder.take(&engine.reports());

        if let (Some(number), Some(picture)) = (image, &self.picture) {
            let path = self.numbered("frame", number, "png");
            picture.save(engine, &path)?;
            self.files.images.push(path.display().to_string());
        }
        if self.writes_particles && (image.is_some() || is_last) {
            let path = self.numbered("particles", self.files.particles.len(), "ply");
            let positions = engine.read(&self.positions).map_err(Failure::stopped)?;
            let velocities = engine.read(&self.velocities).map_err(Failure::stopped)?;
            ply::write(&path, &positions, &velocities, self.scene.domain.min_m)?;
            self.files.particles.push(path.display().to_string());
        }
        Ok(())
    }

    fn numbered(&self, name: &str, number: usize, ending: &str) -> PathBuf {
        self.out.join(format!("{name}_{number:04}.{ending}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_spread_evenly_and_the_last_is_at_the_end() {
        assert_eq!(due_steps(480, 6), [80, 160, 240, 320, 400, 480]);
        assert_eq!(due_steps(10, 3), [3, 6, 10]);
        assert_eq!(due_steps(2, 5), [1, 2]);
        assert_eq!(due_steps(7, 1), [7]);
        assert!(due_steps(7, 0).is_empty());
    }
}
