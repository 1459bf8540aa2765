//! Puts a picture and what stands over it into a window's texture.

use std::time::Instant;

use brooklet_gpu::{FrameReport, Gpu, PassTimer};
use egui::{ClippedPrimitive, TextureId, TexturesDelta};
use egui_wgpu::{Renderer, RendererOptions, ScreenDescriptor};

/// What is painted to.
#[derive(Clone, Copy)]
pub struct Target<'a> {
    /// The window's texture.
    pub view: &'a wgpu::TextureView,
    /// Its size, pixels.
    pub size_px: [u32; 2],
    /// Pixels a point of the user interface.
    pub pixels_per_point: f32,
}

/// Paints the user interface; the picture is one of its images.
pub struct Presenter {
    gpu: Gpu,
    renderer: Renderer,
    picture: Option<TextureId>,
    timer: PassTimer,
}

/// Name of the pass that paints everything but the fluid.
pub const OVERLAY: &str = "overlay";

impl Presenter {
    /// For windows of a format, best one without sRGB encoding of its own: pictures are encoded already.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        // Dithering would put noise on a picture that must be the one that was drawn.
        let options = RendererOptions { dithering: false, ..RendererOptions::default() };
        let timer = PassTimer::new(gpu.device(), gpu.queue(), 1, Instant::now());
        Self { gpu: gpu.clone(), renderer: Renderer::new(gpu.device(), format, options), picture: None, timer }
    }

    /// Shows another picture from now on.
    pub fn show(&mut self, picture: &wgpu::TextureView) -> TextureId {
        let (device, filter) = (self.gpu.device(), wgpu::FilterMode::Linear);
        match self.picture {
            Some(id) => {
                self.renderer.update_egui_texture_from_wgpu_texture(device, picture, filter, id);
                id
            }
            None => *self.picture.insert(self.renderer.register_native_texture(device, picture, filter)),
        }
    }

    /// Times of painting that have come back.
    pub fn reports(&mut self) -> Vec<FrameReport> {
        self.timer.reports()
    }

    /// Paints, and returns the frame's number among those of [`Presenter::reports`].
    pub fn paint(&mut self, target: &Target<'_>, shapes: &[ClippedPrimitive], textures: &mut TexturesDelta) -> u64 {
        let (device, queue) = (self.gpu.device(), self.gpu.queue());
        for (id, deltas) in &textures.set {
            for delta in deltas {
                self.renderer.update_texture(device, queue, *id, delta);
            }
        }
        let screen = ScreenDescriptor { size_in_pixels: target.size_px, pixels_per_point: target.pixels_per_point };
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some(OVERLAY) });
        let before = self.renderer.update_buffers(device, queue, &mut encoder, shapes, &screen);
        let frame = self.timer.begin_frame();
        let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(OVERLAY),
            timestamp_writes: self.timer.render_pass(OVERLAY),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target.view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        self.renderer.render(&mut pass.forget_lifetime(), shapes, &screen);
        self.timer.resolve(&mut encoder);
        queue.submit(before.into_iter().chain([encoder.finish()]));
        for id in &textures.free {
            self.renderer.free_texture(id);
        }
        textures.clear();
        frame
    }
}
