//! `brooklet bench window`: what panels and captures add to a frame of the window, without a window.
//!
//! Three viewers show the same scene on one device, in pictures of one size: one alone, one with its
//! panels, one with a capture. They take turns of some frames each, so that what drifts in a machine
//! drifts for all, and each turn is held against the one alone beside it.

use std::path::{Path, PathBuf};
use std::time::Instant;

use brooklet_capture::CaptureCost;
use brooklet_fluid::Scene;
use brooklet_gpu::Gpu;
use brooklet_viewer::action::Action;
use brooklet_viewer::{Settings, Target, Viewer};
use egui::{Pos2, RawInput, Rect, vec2};
use serde::Serialize;

use crate::{bench_options::WindowOptions, failure::Failure, interrupt::Interrupt, job, progress, table::table};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Bgra8Unorm;
/// So little that no frame has more than one step: all frames do the same.
const BUDGET_MS: f64 = 0.001;
/// Steps before anything is timed.
const WARM_UP: u64 = 12;

/// A viewer that paints on a texture.
struct OffscreenWindow<'a> {
    viewer: Viewer,
    gpu: &'a Gpu,
    view: wgpu::TextureView,
    size_px: [u32; 2],
}

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
    let mut panels = OffscreenWindow::open(&gpu, &scene, size_px, folder.path())?;
    panels.warm_up(&interrupt)?;
    let picture_px = panels.picture_px();
    let alone = || -> Result<OffscreenWindow<'_>, Failure> {
        let mut shown = OffscreenWindow::open(&gpu, &scene, picture_px, folder.path())?;
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

impl<'a> OffscreenWindow<'a> {
    fn open(gpu: &'a Gpu, scene: &Scene, size_px: [u32; 2], folder: &Path) -> Result<Self, Failure> {
        let settings = Settings { folder: folder.to_owned(), budget_ms: BUDGET_MS, auto: false, rung: 0 };
        let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("window"),
            size: wgpu::Extent3d { width: size_px[0], height: size_px[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let mut viewer = Viewer::new(gpu, FORMAT, scene.clone(), settings, size_px);
        // Two simulated seconds a second: a step is always due.
        viewer.handle_action(Action::Speed(2.0));
        Ok(Self { viewer, gpu, view, size_px })
    }

    fn picture_px(&self) -> [u32; 2] {
        self.viewer.current().map_or(self.size_px, |current| current.view().size_px)
    }

    fn steps(&self) -> u64 {
        self.viewer.current().map_or(0, |current| current.session.steps())
    }

    fn frame(&mut self) -> Result<(), Failure> {
        if !self.viewer.has_news().map_err(Failure::stopped)? {
            std::thread::sleep(std::time::Duration::from_micros(200));
            return Ok(());
        }
        let [width, height] = self.size_px.map(|side| side as f32);
        let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, vec2(width, height)));
        let input = RawInput { screen_rect, ..RawInput::default() };
        let target = Target { view: &self.view, size_px: self.size_px, pixels_per_point: 1.0 };
        self.viewer.frame(input, Some(&target)).map_err(Failure::stopped)?;
        Ok(())
    }

    fn warm_up(&mut self, interrupt: &Interrupt) -> Result<(), Failure> {
        while self.steps() < WARM_UP || self.viewer.is_loading() {
            if interrupt.is_pressed() {
                return Err(Failure::Interrupted("nothing was timed".into()));
            }
            if let Some(word) = self.viewer.messages().next() {
                return Err(Failure::Input(word.to_owned()));
            }
            self.frame()?;
        }
        Ok(())
    }

    /// So many frames, all done; ms of one.
    fn turn(&mut self, frames: u64) -> Result<f64, Failure> {
        // The first one fills what another viewer left cold.
        let before = self.steps();
        while self.steps() < before + 1 {
            self.frame()?;
        }
        self.wait();
        let (begun, before) = (Instant::now(), self.steps());
        while self.steps() < before + frames {
            self.frame()?;
        }
        self.wait();
        Ok(1e3 * begun.elapsed().as_secs_f64() / frames as f64)
    }

    fn wait(&self) {
        // A lost device is found by the next frame.
        let _ = self.gpu.device().poll(wgpu::PollType::wait_indefinitely());
    }
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
