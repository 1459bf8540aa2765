//! The app: its device, its viewer, and the window that comes and goes.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use brooklet_gpu::{Gpu, GpuOptions, vulkan_instance};
use brooklet_viewer::{Kind, Painted, Settings, Target, Viewer};
use egui::{Pos2, RawInput, Rect, vec2};

use crate::canvas::{Canvas, Picture, SharedWindow, SurfaceLost, WindowSource};
use crate::touch::{Acceleration, TouchEvent, Touches};

/// Folders of the app's own.
#[derive(Clone, Debug)]
pub struct AppPaths {
    /// Captures and pictures, where the user finds them.
    pub files: PathBuf,
    /// Compiled pipelines.
    pub cache: PathBuf,
}

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
const BUSY: Duration = Duration::from_millis(2);
/// A window that gives no frame is asked so often.
const HIDDEN: Duration = Duration::from_millis(100);
/// A device that is lost again within this time is not opened a third time.
const LOST_AGAIN: Duration = Duration::from_secs(20);

/// The app.
pub struct App {
    paths: AppPaths,
    instance: Option<wgpu::Instance>,
    open: Option<Open>,
    shown: Option<Shown>,
    touches: Touches,
    /// Whether something happened since the last frame.
    touched: bool,
    lost: Option<Instant>,
    failure: Option<String>,
}

/// All that goes when the device goes.
struct Open {
    viewer: Viewer,
    format: wgpu::TextureFormat,
    gpu: Gpu,
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
            instance: None,
            open: None,
            shown: None,
            touches: Touches::default(),
            touched: true,
            lost: None,
            failure: None,
        }
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

    /// Lets the window go, and writes what there is of the capture.
    pub fn suspend(&mut self) {
        self.touches.cancel();
        self.shown = None;
        if let Some(open) = &mut self.open {
            open.viewer.flush_capture();
        }
    }

    /// Takes what a finger did.
    pub fn touch(&mut self, event: TouchEvent) {
        let Some(shown) = &self.shown else { return };
        self.touches.take(event, shown.pixels_per_point);
    }

    /// Takes a reading of the accelerometer.
    pub fn acceleration(&mut self, _reading: Acceleration) {}

    /// Takes how near the device is to being slowed down for its heat: 0 is cool, 1 is there, NaN is unknown.
    pub fn thermal_headroom(&mut self, _headroom: f32) {}

    /// The system is short of memory.
    pub fn low_memory(&mut self) {}

    /// The back key; false if the app should go to the background.
    pub fn back(&mut self) -> bool {
        false
    }

    /// What keeps the app from showing anything, in words for a screen of text; none if nothing does.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// The viewer, once there is a device.
    pub fn viewer(&self) -> Option<&Viewer> {
        self.open.as_ref().map(|open| &open.viewer)
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
        let (size_px, pixels_per_point) = (shown.canvas.size_px(), shown.pixels_per_point);
        let [width, height] = size_px.map(|side| side as f32 / pixels_per_point);
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(width, height))),
            events: self.touches.events(),
            max_texture_side: Some(open.gpu.device().limits().max_texture_dimension_2d as usize),
            ..RawInput::default()
        };
        input.viewports.entry(input.viewport_id).or_default().native_pixels_per_point = Some(pixels_per_point);
        let target = Target { view: &view, size_px, pixels_per_point };
        match open.viewer.frame_with(input, Some(&target), None) {
            Ok(painted) => {
                shown.canvas.show(&open.gpu, sheet);
                wake(&painted)
            }
            Err(error) => self.lose_device(&error.to_string()),
        }
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
                let options = GpuOptions {
                    pipeline_cache: Some(self.paths.cache.clone()),
                    timing: true,
                    ..GpuOptions::default()
                };
                Gpu::open_on(instance, surface.as_ref(), &options).map_err(|error| error.to_string())?
            }
        };
        let canvas = match surface {
            Some(surface) => Canvas::on_surface(surface, &gpu, size_px)?,
            None => Canvas::offscreen(&gpu, size_px),
        };
        let format = canvas.format();
        // A window may come back with another format, for which nothing was built.
        let state = match &mut self.open {
            Some(open) if open.format == format => {
                open.viewer.repaint();
                return Ok(Shown { window, canvas, pixels_per_point });
            }
            open => open.take().map(|mut open| {
                (open.viewer.take_state(), open.viewer.rung(), open.viewer.is_auto())
            }),
        };
        let settings = Settings { folder: self.paths.files.clone(), budget_ms: None, rung: None };
        let mut viewer = Viewer::without_scene(&gpu, format, settings, canvas.size_px());
        match state {
            Some((Some(state), rung, auto)) => viewer.resume(state, rung, auto),
            _ => viewer.open("dam-break"),
        }
        self.open = Some(Open { viewer, format, gpu });
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
        // Everything of the device goes before it is opened again; the instance has the old adapter.
        let shown = self.shown.take();
        let size_px = shown.as_ref().map(|shown| shown.canvas.size_px());
        let again = shown.map(|shown| (shown.window, shown.pixels_per_point));
        (self.open, self.instance) = (None, None);
        if lost_again {
            self.failure = Some(format!("the GPU stopped twice: {reason}"));
            return Wake::OnEvent;
        }
        if let (Some(size_px), Some((window, pixels_per_point))) = (size_px, again) {
            self.show(window, size_px, pixels_per_point);
        }
        if let Some(open) = &mut self.open {
            open.viewer.notify(Kind::Error, format!("the GPU stopped, and was started again: {reason}"));
        }
        Wake::Now
    }
}

fn wake(painted: &Painted) -> Wake {
    match painted.within {
        _ if painted.again => Wake::Now,
        Duration::MAX => Wake::OnEvent,
        within => Wake::After(within),
    }
}
