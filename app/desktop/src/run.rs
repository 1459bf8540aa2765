//! `brooklet run`: simulate, and write pictures, particles, a capture and a summary.

use std::{
    fs,
    path::Path,
    time::{Instant, SystemTime},
};

use brooklet_capture::{CaptureError, CaptureOptions, CaptureWriter, Level, StatField};
use brooklet_fluid::{Scene, captured_fields};
use brooklet_gpu::{Gpu, Plan, TimingStatus, Timings, stages, tier_name, warm_up_frames};
use brooklet_render::left_out::Recorded;
use brooklet_render::surface::marching_cubes::MESH_FIELDS;
use brooklet_render::{Concession, FramePasses};

#[cfg(feature = "clip")]
use crate::clip::Clip;
use crate::{
    cli::RunOptions,
    commit::{COMMIT, VERSION},
    failure::Failure,
    interrupt::Interrupt,
    job,
    out_dir::{self, OutDir},
    progress,
    recorder::Recorder,
    run_mesh::RunMesh,
    running::{Running, due_steps},
    start_run::{self, Started},
    summary::{Facts, Files, Summary},
};

/// Runs a scene.
pub fn run(options: &RunOptions) -> Result<(), Failure> {
    let scene = job::scene(&options.scene, Some(&options.outputs))?;
    let steps = job::steps(&scene, &options.length)?;
    let gpu = job::open(&options.device, !options.outputs.no_timing)?;
    let no_times = match gpu.timing() {
        TimingStatus::Off => Some("--no-timing"),
        TimingStatus::Unsupported => Some("the device gives no timestamps"),
        TimingStatus::PassPerStage | TimingStatus::InsidePasses | TimingStatus::OwnPasses => None,
    };
    let recorded = Recorded { no_times, no_capture: options.outputs.no_capture };
    let start = SystemTime::now();
    let Started { scene, concessions, session, passes, mesh_room, left_out, plan, slots, bytes_per_particle, measures } =
        start_run::start(&gpu, &scene, &recorded)?;
    let repairs = scene.repairs();
    let words = repairs.iter().cloned().chain(concessions.iter().map(ToString::to_string));
    words.for_each(|word| eprintln!("brooklet: {}: {word}", scene.name));
    let export = options.outputs.mesh.map(|format| RunMesh::new(&gpu, &scene, slots, format)).transpose()?;
    let start_relaxation = session.start_relaxation();
    let interrupt = Interrupt::listen()?;
    #[cfg(feature = "clip")]
    if options.clip && (scene.outputs.images == 0 || passes.is_none()) {
        return Err(Failure::Input("--clip: the run has no pictures; --images 1 or more is allowed".into()));
    }

    let default_out = Path::new("out").join(&scene.name);
    let out = OutDir::create(options.out.as_deref().unwrap_or(&default_out))?;
    #[cfg(feature = "clip")]
    let clip = {
        let size_px = [scene.outputs.width_px, scene.outputs.height_px];
        let clip = options.clip.then(|| Clip::new(out.path.join("clip.webp"), size_px)).transpose();
        clip.inspect_err(|_| out.remove())?
    };
    let capture_path = options.capture.clone().unwrap_or_else(|| out.path.join("capture.mcap"));
    let capture = if options.outputs.no_capture {
        None
    } else {
        let capture_options = CaptureOptions {
            stages: stages(plan.passes()).into_iter().map(|(stage, _)| stage.into()).collect(),
            stats: if measures { stat_fields(&scene, passes.as_ref()) } else { Vec::new() },
            start,
            ..CaptureOptions::default()
        };
        Some(
            open_capture(&capture_path, capture_options, (&scene, &concessions), &plan, &gpu)
                .inspect_err(|_| out.remove())?,
        )
    };
    let is_captured = capture.is_some();

    let timings = Timings::new(warm_up_frames(steps));
    let mut running = Running {
        recorder: Recorder::new(session.step_id(), timings, capture),
        scene: &scene,
        out: &out.path,
        steps,
        done: 0,
        images: due_steps(steps, scene.outputs.images),
        session,
        passes,
        mesh_room,
        #[cfg(feature = "clip")]
        clip,
        writes_particles: options.outputs.particles.is_some(),
        files: Files::default(),
        troubles: Vec::new(),
        told_first: false,
        told_unstable: false,
    };
    let begun = Instant::now();
    let bar = progress::bar(steps, "steps");
    let outcome = running.all(&interrupt, &bar);
    bar.finish_and_clear();
    let wall_s = begun.elapsed().as_secs_f64();
    #[cfg(feature = "clip")]
    let clip = running.clip.take().and_then(Clip::finish);

    // Whatever ended the run: what there is of it is closed and told.
    let totals = running.recorder.finish();
    let Running { recorder, done, session, mut files, mut troubles, .. } = running;
    let plan = session.engine().plan().clone();
    troubles.extend(recorder.trouble.as_ref().map(ToString::to_string));
    troubles.extend(outcome.as_ref().err().map(|failure| format!("after {done} of {steps} steps: {}", failure.text())));
    #[cfg(feature = "clip")]
    if let Some((path, written)) = clip {
        let list = if written.is_ok() { &mut files.clip } else { &mut files.not_written };
        list.push(path.display().to_string());
        troubles.extend(written.err().map(|failure| failure.text().to_owned()));
    }
    files.capture = is_captured.then(|| capture_path.display().to_string());
    files.capture_complete = totals.is_some_and(|totals| totals.complete);
    let export = export.filter(|_| outcome.is_ok() && done == steps);
    let mesh = export.and_then(|export| match export.write(session, &scene, &out.path) {
        Ok(mesh) => Some(mesh),
        Err(failure) => {
            troubles.push(failure.text().to_owned());
            None
        }
    });
    let summary_path = out.path.join("summary.json");
    files.summary = summary_path.display().to_string();
    let summary = Summary::new(Facts {
        scene: &scene,
        plan: &plan,
        slots,
        bytes_per_particle,
        steps: done,
        wall_s,
        interrupted: done < steps,
        timings: &recorder.timings,
        measured: &recorder.measured,
        start_relaxation,
        meshes: &recorder.meshes,
        mesh,
        left_out,
        concessions,
        gpu: &gpu,
        files: files.clone(),
    });
    let json = summary.to_json().map_err(Failure::stopped)?;
    let written = out_dir::write_file(&summary_path, json.as_bytes());
    if options.json {
        say!("{json}");
    } else {
        summary.print(plan.bytes());
        print_files(&files, &summary, written.is_ok());
    }
    troubles.extend(written.err().map(|failure| failure.text().to_owned()));
    if !troubles.is_empty() {
        return Err(Failure::Stopped(format!(
            "{}; what was written is in {}",
            troubles.join("; "),
            out.path.display()
        )));
    }
    if done < steps {
        return Err(Failure::Interrupted(format!("{done} of {steps} steps are in {}", out.path.display())));
    }
    Ok(())
}

/// What the capture tells of each measurement: of the fluid, and of the last picture's mesh, if it has one.
fn stat_fields(scene: &Scene, passes: Option<&FramePasses>) -> Vec<StatField> {
    let is_meshed = passes.is_some_and(|passes| passes.mesh_counts().is_some());
    let mesh = MESH_FIELDS.into_iter().filter(|_| is_meshed);
    captured_fields(scene).map(StatField::from).chain(mesh.map(StatField::from)).collect()
}

fn open_capture(
    path: &Path,
    options: CaptureOptions,
    (scene, concessions): (&Scene, &[Concession]),
    plan: &Plan,
    gpu: &Gpu,
) -> Result<CaptureWriter<std::fs::File>, Failure> {
    let write = || {
        let mut capture = CaptureWriter::create(path, options)?;
        capture.device(gpu.info(), tier_name(gpu.tier()))?;
        let build = [("program", "brooklet"), ("version", VERSION), ("commit", COMMIT)];
        capture.metadata("build", build.map(|(key, value)| (key, value.to_string())))?;
        let name = format!("{}.toml", scene.name);
        capture.attach(&name, "application/toml", scene.to_toml().as_bytes())?;
        capture.plan(plan)?;
        for repair in scene.repairs() {
            capture.log(0, Level::Warning, &repair)?;
        }
        for concession in concessions {
            capture.log(0, Level::Warning, &concession.to_string())?;
        }
        Ok(capture)
    };
    write().map_err(|error| match error {
        CaptureError::Write { name, reason, .. } => {
            if fs::metadata(path).is_ok_and(|found| found.is_file()) {
                // Whether or not this works, the run has not begun.
                let _ = fs::remove_file(path);
            }
            Failure::Input(format!("{name}: the capture cannot be begun: {reason}"))
        }
        error => Failure::input(error),
    })
}

fn print_files(files: &Files, summary: &Summary, summary_written: bool) {
    say!();
    match files.images.as_slice() {
        [] => {}
        [only] => say!("picture   {only}"),
        [first, .., last] => {
            say!("pictures  {first} to {last} ({})", files.images.len());
        }
    }
    files.clip.iter().for_each(|clip| say!("clip      {clip}"));
    match files.particles.as_slice() {
        [] => {}
        [only] => say!("particles {only}"),
        [first, .., last] => {
            say!("particles {first} to {last} ({})", files.particles.len());
        }
    }
    summary.print_mesh();
    if let Some(capture) = &files.capture {
        let note = if files.capture_complete { "" } else { " (incomplete)" };
        say!("capture   {capture}{note}");
    }
    if summary_written {
        say!("summary   {}", files.summary);
    }
}
