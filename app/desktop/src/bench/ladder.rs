//! `brooklet bench ladder`: how soon a scene moves in a window that was opened on this device, and what is given up for it.

use std::time::{Duration, Instant};

use brooklet_fluid::{Scene, shipped_scenes};
use brooklet_gpu::Gpu;
use brooklet_viewer::Settings;
use brooklet_viewer::ladder::RUNGS;
use serde::Serialize;

use super::offscreen_window::OffscreenWindow;
use crate::{bench_options::LadderOptions, commit::COMMIT, failure::Failure, interrupt::Interrupt, job, table::table};

/// What is printed.
#[derive(Clone, Debug, Serialize)]
struct Ladder {
    device: String,
    device_type: String,
    window_px: [u32; 2],
    budget_ms: f64,
    /// Frames are counted from so long after opening,
    from_s: f64,
    /// to so long.
    to_s: f64,
    scenes: Vec<Opened>,
    commit: &'static str,
}

/// How a scene went.
#[derive(Clone, Debug, Serialize)]
struct Opened {
    scene: String,
    /// From opening to the first picture of it, s.
    first_picture_s: f64,
    frames_per_s: f64,
    /// Simulated seconds a second.
    speed: f64,
    /// Medians.
    step_ms: f64,
    picture_ms: f64,
    particles: u32,
    picture_px: [u32; 2],
    rung: usize,
    given_up: String,
}

/// Runs and prints it.
pub fn bench(options: &LadderOptions) -> Result<(), Failure> {
    let names: Vec<&str> = match &options.scene {
        Some(name) => vec![name],
        None => shipped_scenes().map(|(name, _)| name).collect(),
    };
    let scenes = names.iter().map(|name| job::load(name, &options.settings)).collect::<Result<Vec<_>, _>>()?;
    let gpu = super::open(&options.device)?;
    let interrupt = Interrupt::listen()?;
    let folder = tempfile::tempdir().map_err(Failure::stopped)?;
    let settings = Settings { folder: folder.path().to_owned(), budget_ms: options.budget, rung: options.rung };
    let mut ladder = Ladder {
        device: gpu.info().name.clone(),
        device_type: gpu.info().device_type.clone(),
        window_px: [options.width, options.height],
        budget_ms: options.budget.unwrap_or_else(|| brooklet_viewer::device_speed::default_budget_ms(&gpu)),
        from_s: options.after,
        to_s: options.after + options.seconds,
        scenes: Vec::new(),
        commit: COMMIT,
    };
    for scene in &scenes {
        let opened = open(&gpu, scene, &settings, &ladder, &interrupt)?;
        if !options.json {
            say!("{}: {:.1} frames/s", opened.scene, opened.frames_per_s);
        }
        ladder.scenes.push(opened);
    }
    if options.json {
        say!("{}", serde_json::to_string_pretty(&ladder).map_err(Failure::stopped)?);
    } else {
        print(&ladder);
    }
    Ok(())
}

fn open(
    gpu: &Gpu,
    scene: &Scene,
    settings: &Settings,
    ladder: &Ladder,
    interrupt: &Interrupt,
) -> Result<Opened, Failure> {
    let opened = Instant::now();
    let seconds = |s: f64| Duration::from_secs_f64(s);
    let mut window = OffscreenWindow::open(gpu, scene, ladder.window_px, settings.clone());
    let (mut first_picture_s, mut counted, mut simulated_s) = (f64::NAN, 0_u32, None);
    let mut frames = 0;
    while opened.elapsed() < seconds(ladder.to_s) {
        if interrupt.is_pressed() {
            return Err(Failure::Interrupted(format!("{} was not timed", scene.name)));
        }
        let before = window.steps();
        window.frame()?;
        let is_timed = opened.elapsed() >= seconds(ladder.from_s);
        let Some(current) = window.viewer.current() else { continue };
        if window.steps() > before {
            frames += 1;
            // The second frame is handed over when the first is nearly there: at most two are under way.
            if frames == 2 {
                first_picture_s = opened.elapsed().as_secs_f64();
            }
            counted += u32::from(is_timed);
        }
        if is_timed && simulated_s.is_none() {
            simulated_s = Some(current.session.simulated_s());
        }
    }
    let timed_s = opened.elapsed().as_secs_f64() - ladder.from_s;
    let rung = window.viewer.rung();
    let (step_ms, picture_ms) = window.viewer.cost_ms().unwrap_or((f64::NAN, f64::NAN));
    let current = window.viewer.current();
    let moved_s = current.map_or(0.0, |current| current.session.simulated_s() - simulated_s.unwrap_or_default());
    Ok(Opened {
        scene: scene.name.clone(),
        first_picture_s,
        frames_per_s: f64::from(counted) / timed_s,
        speed: moved_s / timed_s,
        step_ms,
        picture_ms,
        particles: current.map_or(0, |current| current.session.slot_count()),
        picture_px: window.picture_px(),
        rung,
        given_up: RUNGS[rung].given_up(scene),
    })
}

fn print(ladder: &Ladder) {
    let [width, height] = ladder.window_px;
    say!(
        "\nwindow {width} x {height}, {:.0} ms a frame, on {}; frames from {:.0} to {:.0} s after opening",
        ladder.budget_ms,
        ladder.device,
        ladder.from_s,
        ladder.to_s
    );
    if ladder.device_type == "cpu" {
        say!("(this driver runs on the processor: its times are the processor's)");
    }
    let header = [
        "scene",
        "first picture, s",
        "frames/s",
        "of real time",
        "a step, ms",
        "a picture, ms",
        "particles",
        "picture",
        "rung",
        "given up",
    ];
    let mut list = table(&header, &[1, 2, 3, 4, 5, 6, 7, 8]);
    for opened in &ladder.scenes {
        let [width, height] = opened.picture_px;
        list.add_row([
            opened.scene.clone(),
            format!("{:.1}", opened.first_picture_s),
            format!("{:.1}", opened.frames_per_s),
            format!("{:.2}", opened.speed),
            format!("{:.1}", opened.step_ms),
            format!("{:.1}", opened.picture_ms),
            opened.particles.to_string(),
            format!("{width} x {height}"),
            opened.rung.to_string(),
            opened.given_up.clone(),
        ]);
    }
    say!("{}", list.trim_fmt());
}
