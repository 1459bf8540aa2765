//! A viewer that paints on a texture: the window's frames without a window.

use std::time::Instant;

use brooklet_fluid::Scene;
use brooklet_gpu::Gpu;
use brooklet_viewer::{Settings, Target, Viewer};
use egui::{Pos2, RawInput, Rect, vec2};

use crate::{failure::Failure, interrupt::Interrupt};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Bgra8Unorm;
/// Steps before anything is timed.
const WARM_UP: u64 = 12;

/// A viewer that paints on a texture.
pub struct OffscreenWindow<'a> {
    /// What paints.
    pub viewer: Viewer,
    gpu: &'a Gpu,
    view: wgpu::TextureView,
    size_px: [u32; 2],
}

impl<'a> OffscreenWindow<'a> {
    /// Begins to load `scene`.
    pub fn open(gpu: &'a Gpu, scene: &Scene, size_px: [u32; 2], settings: Settings) -> Self {
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
        let viewer = Viewer::new(gpu, FORMAT, scene.clone(), settings, size_px);
        Self { viewer, gpu, view, size_px }
    }

    /// Size of the fluid's picture.
    pub fn picture_px(&self) -> [u32; 2] {
        self.viewer.current().map_or(self.size_px, |current| current.view().size_px)
    }

    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.viewer.current().map_or(0, |current| current.session.steps())
    }

    /// A frame, if it would show anything new; whether it would.
    pub fn frame(&mut self) -> Result<bool, Failure> {
        if !self.viewer.has_news().map_err(Failure::stopped)? {
            std::thread::sleep(std::time::Duration::from_micros(200));
            return Ok(false);
        }
        let [width, height] = self.size_px.map(|side| side as f32);
        let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, vec2(width, height)));
        let input = RawInput { screen_rect, ..RawInput::default() };
        let target = Target { view: &self.view, size_px: self.size_px, pixels_per_point: 1.0 };
        self.viewer.frame(input, Some(&target)).map_err(Failure::stopped)?;
        Ok(true)
    }

    /// Frames until the scene runs and nothing is cold.
    pub fn warm_up(&mut self, interrupt: &Interrupt) -> Result<(), Failure> {
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
    pub fn turn(&mut self, frames: u64) -> Result<f64, Failure> {
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
