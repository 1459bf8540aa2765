//! An open window: its surface, its device, and the viewer that paints in it.

use std::sync::Arc;

use brooklet_fluid::Scene;
use brooklet_gpu::{Gpu, GpuOptions, Tier, vulkan_instance};
use brooklet_viewer::action::Action;
use brooklet_viewer::surface::{Status, configuration, format_of};
use brooklet_viewer::{Painted, Settings, Target, Viewer, ViewerError};
use egui_winit::State;
use winit::window::Window;

use crate::{failure::Failure, view_options::ViewOptions};

/// All that goes when the device goes.
pub struct Open {
    /// The window.
    pub window: Arc<Window>,
    /// What paints in it.
    pub viewer: Viewer,
    instance: wgpu::Instance,
    /// None only where making another one failed.
    surface: Option<wgpu::Surface<'static>>,
    configuration: wgpu::SurfaceConfiguration,
    gpu: Gpu,
    input: State,
}

/// How a frame went.
pub enum Went {
    /// It was painted.
    Painted(Box<Painted>),
    /// There is nothing to paint on for now.
    Hidden,
    /// The device is gone.
    DeviceLost(String),
}

impl Open {
    /// Opens device and surface for `window`, and begins to load `scene`.
    pub fn new(window: Arc<Window>, options: &ViewOptions, tier: Option<Tier>, scene: Scene) -> Result<Self, Failure> {
        let instance = vulkan_instance();
        let surface = instance
            .create_surface(Arc::clone(&window))
            .map_err(|error| Failure::Input(format!("Vulkan cannot show pictures in a window here: {error}")))?;
        let gpu = Gpu::open_on(
            &instance,
            Some(&surface),
            &GpuOptions {
                device_name: options.device.device.clone(),
                tier,
                pipeline_cache: dirs::cache_dir().map(|folder| folder.join("brooklet")),
                timing: true,
                watch_builds: options.device.careful,
                ..GpuOptions::default()
            },
        )
        .map_err(Failure::input)?;
        let capabilities = surface.get_capabilities(gpu.adapter());
        let format = format_of(&capabilities.formats)
            .ok_or_else(|| Failure::Input(format!("{} has no format for this window", gpu.info().name)))?;
        let size_px: [u32; 2] = window.inner_size().into();
        let configuration = configuration(&capabilities, format, size_px);
        surface.configure(gpu.device(), &configuration);
        let settings = Settings { folder: options.out.clone(), budget_ms: options.budget, rung: options.rung };
        let viewer = Viewer::new(&gpu, format, scene, settings, size_px);
        let scale = Some(window.scale_factor() as f32);
        let side = gpu.device().limits().max_texture_dimension_2d as usize;
        let context = viewer.context().clone();
        let input = State::new(context, egui::ViewportId::ROOT, &window, scale, window.theme(), Some(side));
        Ok(Self { window, viewer, instance, surface: Some(surface), configuration, gpu, input })
    }

    /// What the user did; whether the window has to be painted anew.
    pub fn take(&mut self, event: &winit::event::WindowEvent) -> bool {
        self.input.on_window_event(&self.window, event).repaint
    }

    /// The window has another size.
    pub fn resize(&mut self, size_px: [u32; 2]) {
        // A minimised window has none: what was configured stays.
        if size_px.iter().all(|side| *side > 0) {
            [self.configuration.width, self.configuration.height] = size_px;
            self.configure();
        }
    }

    /// Loses the device, for tests of what happens then.
    pub fn lose_device(&self) {
        self.gpu.device().destroy();
    }

    /// One frame; `is_lost`: as if the surface were lost.
    pub fn frame(&mut self, is_lost: bool) -> Result<Went, Failure> {
        let mut got = if is_lost { wgpu::CurrentSurfaceTexture::Lost } else { self.next_texture() };
        let mut status = Status::of(&got);
        if matches!(status, Status::Lost | Status::Outdated) {
            drop(got);
            if status == Status::Lost {
                // A window has one surface: the old one goes first.
                self.surface = None;
                let surface = self.instance.create_surface(Arc::clone(&self.window));
                let lost = |error| Failure::Stopped(format!("the window's surface is lost: {error}"));
                self.surface = Some(surface.map_err(lost)?);
            }
            self.configure();
            got = self.next_texture();
            status = Status::of(&got);
        }
        let texture = match got {
            wgpu::CurrentSurfaceTexture::Success(texture) | wgpu::CurrentSurfaceTexture::Suboptimal(texture) => texture,
            _ => return Ok(self.lost().unwrap_or(Went::Hidden)),
        };
        let view = texture.texture.create_view(&wgpu::TextureViewDescriptor::default());
        let input = self.input.take_egui_input(&self.window);
        let target = Target {
            view: &view,
            size_px: [self.configuration.width, self.configuration.height],
            pixels_per_point: egui_winit::pixels_per_point(self.viewer.context(), &self.window),
        };
        let painted = match self.viewer.frame(input, Some(&target)) {
            Ok(painted) => painted,
            Err(error) if error.is_device_lost() => return Ok(Went::DeviceLost(error.to_string())),
            Err(error @ ViewerError::Gpu(_)) => return Ok(self.lost().unwrap_or(Went::DeviceLost(error.to_string()))),
            Err(error) => return Err(Failure::stopped(error)),
        };
        self.window.pre_present_notify();
        self.gpu.queue().present(texture);
        if status == Status::Suboptimal {
            self.configure();
        }
        self.input.handle_platform_output(&self.window, painted.platform.clone());
        Ok(Went::Painted(Box::new(painted)))
    }

    fn next_texture(&self) -> wgpu::CurrentSurfaceTexture {
        self.surface.as_ref().map_or(wgpu::CurrentSurfaceTexture::Lost, wgpu::Surface::get_current_texture)
    }

    fn configure(&self) {
        if let Some(surface) = &self.surface {
            surface.configure(self.gpu.device(), &self.configuration);
        }
    }

    fn lost(&self) -> Option<Went> {
        self.gpu.is_lost().map(Went::DeviceLost)
    }

    /// The whole screen, or a window again.
    pub fn toggle_fullscreen(&self) {
        let fullscreen = match self.window.fullscreen() {
            Some(_) => None,
            None => Some(winit::window::Fullscreen::Borderless(None)),
        };
        self.window.set_fullscreen(fullscreen);
    }

    /// Opens what was dropped.
    pub fn drop_file(&mut self, path: &std::path::Path) {
        self.viewer.handle_action(Action::Open(path.display().to_string()));
    }
}
