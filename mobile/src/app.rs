//! The app: its device, its viewer, its screen, and the window that comes and goes.

use std::sync::Arc;
use std::time::{Duration, Instant};

use brooklet_gpu::{Gpu, GpuOptions, vulkan_instance};
use brooklet_viewer::panels::{PanelInput, PanelOutput};
use brooklet_viewer::{Kind, Painted, Target, Viewer, ViewerError};
use egui::{Order, Pos2, RawInput, Rect, vec2};

use crate::app_paths::AppPaths;
use crate::canvas::{Canvas, Picture, SharedWindow, SurfaceLost, WindowSource};
use crate::gravity::Gravity;
use crate::heat::Heat;
use crate::open::{Open, is_weightless};
use crate::report;
use crate::screen::{Ask, Screen};
use crate::self_check::{Asked, Checked, Occasion};
use crate::touch::{Acceleration, Place, TouchEvent, Touches};

/// When the next frame is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wake {
    /// At once.
    Now,
    /// After that time, or when something happens before.
    After(Duration),
    /// When something happens.
    OnEvent,
}

/// A busy GPU is asked so often whether it is done.
pub(crate) const BUSY: Duration = Duration::from_millis(2);
/// A window that gives no frame, and a check under way, are asked so often.
const HIDDEN: Duration = Duration::from_millis(100);
/// A device that is lost again within this time is not opened a third time.
const LOST_AGAIN: Duration = Duration::from_secs(20);

/// The app.
pub struct App {
    paths: AppPaths,
    options: GpuOptions,
    asked: Asked,
    report_time: Duration,
    instance: Option<wgpu::Instance>,
    open: Option<Open>,
    shown: Option<Shown>,
    screen: Screen,
    touches: Touches,
    gravity: Gravity,
    heat: Heat,
    /// Whether something happened since the last frame.
    touched: bool,
    lost: Option<Instant>,
    failure: Option<String>,
}

/// All that goes when the window goes.
struct Shown {
    window: Option<SharedWindow>,
    canvas: Canvas,
    pixels_per_point: f32,
}

impl App {
    /// Opens nothing yet.
    pub fn new(paths: AppPaths) -> App {
        App {
            paths,
            options: GpuOptions { timing: true, ..GpuOptions::default() },
            asked: Asked::default(),
            report_time: report::TIME,
            instance: None,
            open: None,
            shown: None,
            screen: Screen::default(),
            touches: Touches::default(),
            gravity: Gravity::default(),
            heat: Heat::default(),
            touched: true,
            lost: None,
            failure: None,
        }
    }

    /// As a device is opened, but for the folder of its pipelines: a tier, a name.
    pub fn with_gpu_options(self, options: GpuOptions) -> App {
        App { options, ..self }
    }

    /// What the self-check asks, where that is not all: to see what becomes of a wrong kernel.
    pub fn with_asked(self, asked: Asked) -> App {
        App { asked, ..self }
    }

    /// How long a report times a scene at most.
    pub fn with_report_time(self, report_time: Duration) -> App {
        App { report_time, ..self }
    }

    /// Shows itself in a window from now on. Device, queue and scene are made by the first call, and kept until the device
    /// is lost. What goes wrong is [`App::failure`]; the next call tries again.
    pub fn resume(&mut self, window: Box<dyn WindowSource>, size_px: [u32; 2], pixels_per_point: f32) {
        self.show(Some(SharedWindow(Arc::from(window))), size_px, pixels_per_point);
    }

    /// As [`App::resume`], without a window: frames are painted on a texture, which [`App::picture`] reads.
    pub fn resume_offscreen(&mut self, size_px: [u32; 2], pixels_per_point: f32) {
        self.show(None, size_px, pixels_per_point);
    }

    /// Lets the window go, writes what there is of the capture, and waits a little for the case of a self-check or the part of
    /// a report that is under way: drivers crash where a program is ended while they build. Whether nothing is under way then.
    pub fn suspend(&mut self) -> bool {
        self.touches.cancel();
        self.shown = None;
        let patience = self.asked.patience;
        self.open.as_mut().is_none_or(|open| {
            open.viewer.flush_capture();
            open.stand(patience)
        })
    }

    /// Takes what a finger did.
    pub fn touch(&mut self, event: TouchEvent) {
        let (Some(open), Some(shown)) = (&self.open, &self.shown) else { return };
        let context = open.viewer.context();
        // As the last frame had it: what is over the picture are areas, the picture is behind them.
        let place = |at| match context.layer_id_at(at) {
            Some(layer) if layer.order != Order::Background => Place::Panel,
            _ => Place::Picture,
        };
        self.touches.take(event, shown.pixels_per_point, place);
    }

    /// Takes a reading of the accelerometer. The first one, and what the level button is touched at, is level.
    pub fn acceleration(&mut self, reading: Acceleration) {
        self.gravity.take(&reading, Instant::now());
    }

    /// Takes how near the device is to being slowed down for its heat: 0 is cool, 1 is there, NaN is unknown.
    pub fn thermal_headroom(&mut self, headroom: f32) {
        self.heat.take_headroom(headroom);
    }

    /// The system is short of memory: what is kept for later goes, and some of the particles.
    pub fn low_memory(&mut self) {
        let Some(open) = &mut self.open else { return };
        open.gpu.trim();
        open.viewer.give_up_particles("the system is short of memory");
        self.touched = true;
    }

    /// The back key: closes what is open over the picture; false if the app should go to the background.
    pub fn back(&mut self) -> bool {
        self.touched = true;
        self.screen.back()
    }

    /// What keeps the app from showing anything, in words for a screen of text; none if nothing does.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// The viewer, once there is a device.
    pub fn viewer(&self) -> Option<&Viewer> {
        self.open.as_ref().map(|open| &open.viewer)
    }

    /// The viewer, for a program that drives it without fingers.
    pub fn viewer_mut(&mut self) -> Option<&mut Viewer> {
        self.touched = true;
        self.open.as_mut().map(|open| &mut open.viewer)
    }

    /// The device, once there is one.
    pub fn gpu(&self) -> Option<&Gpu> {
        self.open.as_ref().map(|open| &open.gpu)
    }

    /// What the self-check found on this device, once it is known.
    pub fn checked(&self) -> Option<&Checked> {
        self.open.as_ref()?.checked.as_ref()
    }

    /// What was painted last, where that is no window.
    pub fn picture(&self) -> Option<Picture> {
        let (open, shown) = (self.open.as_ref()?, self.shown.as_ref()?);
        shown.canvas.read(&open.gpu)
    }

    /// One frame, if it would show anything new.
    pub fn frame(&mut self) -> Wake {
        if self.failure.is_some() {
            return Wake::OnEvent;
        }
        if let Some(open) = &mut self.open {
            self.touched |= open.follow(&self.paths.files);
        }
        self.sense();
        let (Some(open), Some(shown)) = (&mut self.open, &mut self.shown) else { return Wake::OnEvent };
        let is_new = std::mem::take(&mut self.touched) | self.touches.is_new();
        match open.viewer.has_news() {
            Ok(false) if !is_new => return Wake::After(BUSY),
            Ok(_) => {}
            Err(error) => return self.lose_device(&error.to_string()),
        }
        let sheet = match shown.canvas.next(&open.gpu) {
            Ok(Some(sheet)) => sheet,
            Ok(None) => {
                self.touched = true;
                return match open.gpu.is_lost() {
                    Some(reason) => self.lose_device(&reason),
                    None => Wake::After(HIDDEN),
                };
            }
            Err(SurfaceLost) => return self.rebuild(),
        };
        let Some(view) = shown.canvas.view(&sheet) else { return Wake::OnEvent };
        let size_px = shown.canvas.size_px();
        let target = Target { view: &view, size_px, pixels_per_point: shown.pixels_per_point };
        match self.paint(&target) {
            Ok((painted, asks)) => {
                if let (Some(open), Some(shown)) = (&self.open, &self.shown) {
                    shown.canvas.show(&open.gpu, sheet);
                }
                let asked = !asks.is_empty();
                asks.into_iter().for_each(|ask| self.answer(ask));
                if asked { Wake::Now } else { self.wake(&painted) }
            }
            Err(error) => self.lose_device(&error.to_string()),
        }
    }

    fn paint(&mut self, target: &Target<'_>) -> Result<(Painted, Vec<Ask>), ViewerError> {
        let Some(open) = &mut self.open else { return Err(ViewerError::NoPicture) };
        let [width, height] = target.size_px.map(|side| side as f32 / target.pixels_per_point);
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(width, height))),
            events: self.touches.events(),
            max_texture_side: Some(open.gpu.device().limits().max_texture_dimension_2d as usize),
            ..RawInput::default()
        };
        let viewport = input.viewports.entry(input.viewport_id).or_default();
        viewport.native_pixels_per_point = Some(target.pixels_per_point);
        let files = self.paths.files.display().to_string();
        let facts = open.facts(self.gravity.is_known(), &files);
        let (screen, mut asks) = (&mut self.screen, Vec::new());
        let mut face = |ui: &mut egui::Ui, shown: &PanelInput<'_>, output: &mut PanelOutput| {
            asks = screen.show(ui, shown, &facts, output);
        };
        let painted = open.viewer.frame_with(input, Some(target), Some(&mut face))?;
        Ok((painted, asks))
    }

    fn answer(&mut self, ask: Ask) {
        self.touched = true;
        let Some(open) = &mut self.open else { return };
        match ask {
            Ask::Level => match self.gravity.set_level() {
                true => open.viewer.notify(Kind::Done, "this is level now"),
                false => open.viewer.notify(Kind::Warning, "the sensor does not say which way is down: hold still"),
            },
            Ask::Check => open.begin_check(&self.asked, Occasion::Menu),
            Ask::Report => {
                let picture_px = self.shown.as_ref().map_or([1, 1], |shown| shown.canvas.size_px());
                open.begin_report(picture_px, self.report_time);
            }
        }
    }

    /// Gravity and heat, as they are now.
    fn sense(&mut self) {
        let Some(open) = &mut self.open else { return };
        let now = Instant::now();
        if let Some(current) = open.viewer.current() {
            let axes = current.view().camera.axes();
            let gravity = self.gravity.now([axes.x_axis, axes.y_axis, axes.z_axis], now);
            // What is in free space stays there, however the phone is held.
            let gravity = gravity.filter(|_| !is_weightless(&current.scene));
            open.viewer.set_gravity(gravity.map(|gravity| gravity.to_array()));
        }
        if let Some((step_ms, draw_ms)) = open.viewer.cost_ms() {
            self.heat.take_frame(open.viewer.rung(), step_ms + draw_ms, now);
        }
        open.viewer.be_strict(self.heat.share());
    }

    fn show(&mut self, window: Option<SharedWindow>, size_px: [u32; 2], pixels_per_point: f32) {
        self.shown = None;
        (self.failure, self.touched) = (None, true);
        let sensible = pixels_per_point.is_finite() && pixels_per_point > 0.0;
        let pixels_per_point = if sensible { pixels_per_point.clamp(0.5, 8.0) } else { 1.0 };
        match self.try_to_show(window, size_px, pixels_per_point) {
            Ok(shown) => self.shown = Some(shown),
            Err(reason) => self.failure = Some(reason),
        }
    }

    fn try_to_show(
        &mut self,
        window: Option<SharedWindow>,
        size_px: [u32; 2],
        pixels_per_point: f32,
    ) -> Result<Shown, String> {
        let instance = self.instance.get_or_insert_with(vulkan_instance);
        let made = window.clone().map(|window| instance.create_surface(window)).transpose();
        let surface = made.map_err(|error| format!("Vulkan cannot show pictures in this window: {error}"))?;
        let gpu = match &self.open {
            Some(open) => open.gpu.clone(),
            None => {
                let cache = Some(self.paths.cache.clone());
                let options = GpuOptions { pipeline_cache: cache, watch_builds: true, ..self.options.clone() };
                Gpu::open_on(instance, surface.as_ref(), &options).map_err(|error| error.to_string())?
            }
        };
        let canvas = match surface {
            Some(surface) => Canvas::on_surface(surface, &gpu, size_px)?,
            None => Canvas::offscreen(&gpu, size_px),
        };
        match &mut self.open {
            Some(open) if open.format == canvas.format() => open.viewer.repaint(),
            Some(open) => open.change_format(&canvas, &self.paths),
            None => self.open = Some(Open::new(gpu, &canvas, &self.paths, &self.asked)),
        }
        if let Some(open) = &self.open {
            open.go_on();
        }
        Ok(Shown { window, canvas, pixels_per_point })
    }

    /// Another surface of the same window.
    fn rebuild(&mut self) -> Wake {
        let Some(Shown { window, canvas, pixels_per_point }) = self.shown.take() else { return Wake::OnEvent };
        let size_px = canvas.size_px();
        // A window has one surface: the old one goes first.
        drop(canvas);
        self.show(window, size_px, pixels_per_point);
        Wake::Now
    }

    /// Opens the device anew, and says why; not a second time in a row.
    fn lose_device(&mut self, reason: &str) -> Wake {
        let lost_again = self.lost.is_some_and(|lost| lost.elapsed() < LOST_AGAIN);
        self.lost = Some(Instant::now());
        let shown = self
            .shown
            .take()
            .map(|Shown { window, canvas, pixels_per_point }| (window, canvas.size_px(), pixels_per_point));
        // Everything of the device goes before it is opened again.
        (self.open, self.instance) = (None, None);
        if lost_again {
            self.failure = Some(format!("the GPU stopped twice: {reason}"));
            return Wake::OnEvent;
        }
        if let Some((window, size_px, pixels_per_point)) = shown {
            self.show(window, size_px, pixels_per_point);
        }
        if let Some(open) = &mut self.open {
            open.viewer.notify(Kind::Error, format!("the GPU stopped, and was started again: {reason}"));
        }
        Wake::Now
    }

    fn wake(&self, painted: &Painted) -> Wake {
        let is_checking = self.open.as_ref().is_some_and(Open::is_at_work);
        match painted.within {
            _ if painted.again => Wake::Now,
            // Water that is tilted while it stands still is not simulated.
            within if is_checking => Wake::After(within.min(HIDDEN)),
            Duration::MAX => Wake::OnEvent,
            within => Wake::After(within),
        }
    }
}
