//! A scene in Android's window until `brooklet-mobile` has the phone's own screen: the desktop window's viewer, fed with
//! touches. It has the interface agreed on for that, so that nothing but names changes here then.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use brooklet_fluid::Scene;
use brooklet_gpu::{Gpu, GpuOptions, vulkan_instance};
use brooklet_viewer::{Kind, Settings, Target, Viewer};
use egui::{Event, PointerButton, RawInput, TouchDeviceId, TouchId, ViewportId, pos2, vec2};
use raw_window_handle::{HasDisplayHandle, HasWindowHandle};

/// Where the app keeps files.
#[derive(Clone, Debug)]
pub struct AppPaths {
    /// Captures, pictures and states.
    pub files: PathBuf,
    /// What can be made again.
    pub cache: PathBuf,
}

/// What a surface is made of.
pub trait WindowSource: HasWindowHandle + HasDisplayHandle + std::fmt::Debug + Send + Sync {}

/// What a finger does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TouchPhase {
    /// It comes.
    Start,
    /// It moves.
    Move,
    /// It goes.
    End,
    /// The system took it.
    Cancel,
}

/// A finger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchEvent {
    /// The same from start to end.
    pub id: u64,
    /// What it does.
    pub phase: TouchPhase,
    /// Pixels from the window's left.
    pub x_px: f32,
    /// Pixels from the window's top.
    pub y_px: f32,
}

/// When the next frame is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wake {
    /// At once.
    Now,
    /// At the latest then.
    After(Duration),
    /// When something happens.
    OnEvent,
}

/// Milliseconds a frame may take: 30 a second.
const BUDGET_MS: f64 = 33.3;
/// The scene that is opened.
const SCENE: &str = "dam-break";
/// How soon a surface that gave nothing is asked again.
const PATIENCE: Duration = Duration::from_millis(50);

/// A viewer and what it shows itself in.
pub struct App {
    paths: AppPaths,
    instance: wgpu::Instance,
    /// Kept while there is no surface.
    opened: Option<Opened>,
    surface: Option<Shown>,
    events: Vec<Event>,
    /// The finger that is the pointer.
    first: Option<u64>,
    began: Instant,
    problem: Option<String>,
}

struct Opened {
    gpu: Gpu,
    viewer: Viewer,
    format: wgpu::TextureFormat,
}

struct Shown {
    surface: wgpu::Surface<'static>,
    size_px: [u32; 2],
    pixels_per_point: f32,
}

impl App {
    /// Nothing is opened before there is a window.
    pub fn new(paths: AppPaths) -> Self {
        Self {
            paths,
            instance: vulkan_instance(),
            opened: None,
            surface: None,
            events: Vec::new(),
            first: None,
            began: Instant::now(),
            problem: None,
        }
    }

    /// Why nothing can be shown on this device.
    pub fn problem(&self) -> Option<&str> {
        self.problem.as_deref()
    }

    /// Makes a surface; the first one decides on the device.
    pub fn resume(&mut self, window: Box<dyn WindowSource>, size_px: [u32; 2], pixels_per_point: f32) {
        if let Err(problem) = self.show(window, size_px, pixels_per_point) {
            self.problem = Some(problem);
        }
    }

    fn show(&mut self, window: Box<dyn WindowSource>, size_px: [u32; 2], pixels_per_point: f32) -> Result<(), String> {
        let surface = self
            .instance
            .create_surface(Handles(window))
            .map_err(|error| format!("Vulkan cannot show pictures in a window here: {error}"))?;
        if self.opened.is_none() {
            let options =
                GpuOptions { pipeline_cache: Some(self.paths.cache.clone()), timing: true, ..Default::default() };
            let gpu = Gpu::open_on(&self.instance, Some(&surface), &options).map_err(|error| error.to_string())?;
            let format = format_of(&surface.get_capabilities(gpu.adapter()).formats)
                .ok_or_else(|| format!("{} has no format for this window", gpu.info().name))?;
            let scene = Scene::load(SCENE, &[]).map_err(|error| error.to_string())?;
            let settings = Settings { folder: self.paths.files.clone(), budget_ms: BUDGET_MS, auto: true, rung: 0 };
            let viewer = Viewer::new(&gpu, format, scene, settings, size_px);
            self.opened = Some(Opened { gpu, viewer, format });
        }
        if let Some(opened) = &self.opened {
            surface.configure(opened.gpu.device(), &configuration(opened.format, size_px));
        }
        self.surface = Some(Shown { surface, size_px, pixels_per_point });
        Ok(())
    }

    /// Drops the surface.
    pub fn suspend(&mut self) {
        self.surface = None;
    }

    /// A finger: the first one is the pointer as well.
    pub fn touch(&mut self, touch: TouchEvent) {
        let Some(shown) = &self.surface else { return };
        let pos = pos2(touch.x_px, touch.y_px) / shown.pixels_per_point;
        let phase = match touch.phase {
            TouchPhase::Start => egui::TouchPhase::Start,
            TouchPhase::Move => egui::TouchPhase::Move,
            TouchPhase::End => egui::TouchPhase::End,
            TouchPhase::Cancel => egui::TouchPhase::Cancel,
        };
        self.events.push(Event::Touch { device_id: TouchDeviceId(0), id: TouchId(touch.id), phase, pos, force: None });
        let button = |pressed| Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Default::default(),
        };
        match touch.phase {
            TouchPhase::Start if self.first.is_none() => {
                self.first = Some(touch.id);
                self.events.extend([Event::PointerMoved(pos), button(true)]);
            }
            TouchPhase::Move if self.first == Some(touch.id) => self.events.push(Event::PointerMoved(pos)),
            TouchPhase::End | TouchPhase::Cancel if self.first == Some(touch.id) => {
                self.first = None;
                self.events.extend([button(false), Event::PointerGone]);
            }
            _ => {}
        }
    }

    /// Says in the window that the device is about to slow down.
    pub fn thermal_headroom(&mut self, headroom: f32) {
        if let (true, Some(opened)) = (headroom >= 1.0, &mut self.opened) {
            opened
                .viewer
                .notify(Kind::Done, format!("the device is hot and slows down (thermal headroom {headroom:.2})"));
        }
    }

    /// One frame.
    pub fn frame(&mut self) -> Wake {
        match self.paint() {
            Ok(wake) => wake,
            Err(problem) => {
                self.problem = Some(problem);
                Wake::OnEvent
            }
        }
    }

    fn paint(&mut self) -> Result<Wake, String> {
        let (Some(opened), Some(shown)) = (&mut self.opened, &self.surface) else { return Ok(Wake::OnEvent) };
        if let Some(reason) = opened.gpu.is_lost() {
            return Err(format!("the device is lost: {reason}"));
        }
        let texture = match shown.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(texture) | wgpu::CurrentSurfaceTexture::Suboptimal(texture) => texture,
            wgpu::CurrentSurfaceTexture::Outdated | wgpu::CurrentSurfaceTexture::Validation => {
                shown.surface.configure(opened.gpu.device(), &configuration(opened.format, shown.size_px));
                return Ok(Wake::Now);
            }
            _ => return Ok(Wake::After(PATIENCE)),
        };
        let view = texture.texture.create_view(&wgpu::TextureViewDescriptor::default());
        let points = vec2(shown.size_px[0] as f32, shown.size_px[1] as f32) / shown.pixels_per_point;
        let mut input = RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, points)),
            events: std::mem::take(&mut self.events),
            time: Some(self.began.elapsed().as_secs_f64()),
            ..RawInput::default()
        };
        input.viewports.entry(ViewportId::ROOT).or_default().native_pixels_per_point = Some(shown.pixels_per_point);
        let target = Target { view: &view, size_px: shown.size_px, pixels_per_point: shown.pixels_per_point };
        let painted = opened.viewer.frame(input, Some(&target)).map_err(|error| error.to_string())?;
        opened.gpu.queue().present(texture);
        Ok(if painted.again { Wake::Now } else { Wake::After(painted.within) })
    }
}

/// wgpu takes no trait of ours.
#[derive(Debug)]
struct Handles(Box<dyn WindowSource>);

impl HasWindowHandle for Handles {
    fn window_handle(&self) -> Result<raw_window_handle::WindowHandle<'_>, raw_window_handle::HandleError> {
        self.0.window_handle()
    }
}

impl HasDisplayHandle for Handles {
    fn display_handle(&self) -> Result<raw_window_handle::DisplayHandle<'_>, raw_window_handle::HandleError> {
        self.0.display_handle()
    }
}

/// One that takes display colours as they are, as pictures are.
fn format_of(formats: &[wgpu::TextureFormat]) -> Option<wgpu::TextureFormat> {
    let plain = |format: &&wgpu::TextureFormat| {
        matches!(format, wgpu::TextureFormat::Bgra8Unorm | wgpu::TextureFormat::Rgba8Unorm)
    };
    formats.iter().find(plain).or_else(|| formats.first()).copied()
}

fn configuration(format: wgpu::TextureFormat, size_px: [u32; 2]) -> wgpu::SurfaceConfiguration {
    wgpu::SurfaceConfiguration {
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        format,
        width: size_px[0].max(1),
        height: size_px[1].max(1),
        // Every Vulkan device has it.
        present_mode: wgpu::PresentMode::Fifo,
        desired_maximum_frame_latency: 1,
        alpha_mode: wgpu::CompositeAlphaMode::Auto,
        view_formats: Vec::new(),
        color_space: Default::default(),
    }
}
