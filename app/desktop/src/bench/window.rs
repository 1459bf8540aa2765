//! `brooklet bench window`: what panels and captures add to a frame of the window, without a window.
//!
//! Three viewers show the same scene on one device, in pictures of one size: one alone, one with its
//! panels, one with a capture. They take turns of some frames each, so that what drifts in a machine
//! drifts for all, and each turn is held against the one alone beside it.

use std::path::{Path, PathBuf};

use brooklet_capture::CaptureCost;
use brooklet_viewer::Settings;
use brooklet_viewer::action::Action;
use serde::Serialize;

use super::offscreen_window::OffscreenWindow;
use crate::{bench_options::WindowOptions, failure::Failure, interrupt::Interrupt, job, progress, table::table};

/// So little that no frame has more than one step: all frames do the same.
const BUDGET_MS: f64 = 0.001;
/// What is printed.
#[derive(Clone, Debug, Serialize)]
struct WindowCost {
    device: String,
    device_type: String,
    scene: String,
    particles: u32,
    window_px: [u32; 2],
    picture_px: [u32; 2],
    pairs: usize,
    frames_a_turn: u64,
    plain_ms: f64,
    /// What the panels add, as a share of a frame, and between what half of the pairs lie.
    panels_share: f64,
    panels_quartiles: [f64; 2],
    /// What the capture adds.
    capture_share: f64,
    capture_quartiles: [f64; 2],
    capture: Option<PathBuf>,
}

/// Runs and prints it.
pub fn bench(options: &WindowOptions) -> Result<(), Failure> {
    let scene = job::load(&options.scene, &options.settings)?;
    let gpu = super::open(&options.device)?;
    let interrupt = Interrupt::listen()?;
    let folder = tempfile::tempdir().map_err(Failure::stopped)?;
    let size_px = [options.width, options.height];
    let settings = Settings { folder: folder.path().to_owned(), budget_ms: Some(BUDGET_MS), rung: Some(0) };
    let open = |size_px| {
        let mut shown = OffscreenWindow::open(&gpu, &scene, size_px, settings.clone());
        // Two simulated seconds a second: a step is always due.
        shown.viewer.handle_action(Action::Speed(2.0));
        shown
    };
    let mut panels = open(size_px);
    panels.warm_up(&interrupt)?;
    let picture_px = panels.picture_px();
    let alone = || -> Result<OffscreenWindow<'_>, Failure> {
        let mut shown = open(picture_px);
        shown.viewer.handle_action(Action::Panels);
        shown.warm_up(&interrupt)?;
        Ok(shown)
    };
    let (mut plain, mut captured) = (alone()?, alone()?);
    captured.viewer.handle_action(Action::Capture);
    let capture = captured.viewer.capture().map(Path::to_path_buf);
    let turns = u64::from(options.pairs);
    let bar = progress::bar(turns, "steps");
    let (mut with_panels, mut with_capture) = (Vec::new(), Vec::new());
    for _ in 0..turns {
        if interrupt.is_pressed() {
            break;
        }
        let first_ms = plain.turn(options.frames)?;
        with_panels.push((panels.turn(options.frames)?, first_ms));
        let second_ms = plain.turn(options.frames)?;
        with_capture.push((captured.turn(options.frames)?, second_ms));
        bar.inc(1);
    }
    bar.finish_and_clear();
    let costs = CaptureCost::of_pairs(&with_panels).zip(CaptureCost::of_pairs(&with_capture));
    let (of_panels, of_capture) = costs.ok_or_else(|| Failure::Interrupted("nothing was timed".into()))?;
    captured.viewer.record_cost(&of_capture);
    let kept = keep(captured, capture, options.capture.as_deref())?;
    let cost = WindowCost {
        device: gpu.info().name.clone(),
        device_type: gpu.info().device_type.clone(),
        scene: scene.name.clone(),
        particles: plain.viewer.current().map_or(0, |current| current.session.slot_count()),
        window_px: size_px,
        picture_px,
        pairs: with_panels.len(),
        frames_a_turn: options.frames,
        plain_ms: of_panels.without_ms,
        panels_share: of_panels.share,
        panels_quartiles: of_panels.quartiles,
        capture_share: of_capture.share,
        capture_quartiles: of_capture.quartiles,
        capture: kept,
    };
    if options.json {
        say!("{}", serde_json::to_string_pretty(&cost).map_err(Failure::stopped)?);
    } else {
        print(&cost);
    }
    Ok(())
}

/// Ends the capture, and moves it to where it is wanted.
fn keep(captured: OffscreenWindow<'_>, from: Option<PathBuf>, to: Option<&Path>) -> Result<Option<PathBuf>, Failure> {
    drop(captured);
    let (Some(from), Some(to)) = (from, to) else { return Ok(None) };
    let failed = |error| Failure::Stopped(format!("--capture {}: {error}", to.display()));
    // Another disk may lie between: copied to a name beside it, which then becomes the file.
    let mut unfinished = to.as_os_str().to_owned();
    unfinished.push(".part");
    std::fs::copy(&from, &unfinished).and_then(|_| std::fs::rename(&unfinished, to)).map_err(failed)?;
    Ok(Some(to.to_owned()))
}

fn print(cost: &WindowCost) {
    let [width, height] = cost.window_px;
    let [picture_width, picture_height] = cost.picture_px;
    say!(
        "{}: {} particles, window {width} x {height}, picture {picture_width} x {picture_height}, on {}",
        cost.scene,
        cost.particles,
        cost.device
    );
    if cost.device_type == "cpu" {
        say!("(this driver runs on the processor: its times are the processor's)");
    }
    let mut list = table(&["", "of a frame", "half of the pairs"], &[1, 2]);
    let percent = |share: f64| format!("{:+.2} %", 100.0 * share);
    let rows = [
        ("panels and plots", cost.panels_share, cost.panels_quartiles),
        ("capture", cost.capture_share, cost.capture_quartiles),
    ];
    for (name, share, [low, high]) in rows {
        list.add_row([name.to_owned(), percent(share), format!("{} to {}", percent(low), percent(high))]);
    }
    say!("{}", list.trim_fmt());
    say!("a frame alone: {:.2} ms, median of {} turns of {} frames", cost.plain_ms, cost.pairs, cost.frames_a_turn);
}
