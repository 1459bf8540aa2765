//! What frames are painted on: a window's surface, or a texture where there is no window.

use std::sync::Arc;

use brooklet_gpu::Gpu;
use brooklet_viewer::surface::{Status, configuration, format_of};
use wgpu::rwh::{DisplayHandle, HandleError, HasDisplayHandle, HasWindowHandle, WindowHandle};
use wgpu::{CurrentSurfaceTexture as Got, SurfaceTexture, Texture, TextureFormat, TextureView};

/// A window as a surface is made of it. It lives for as long as it is an [`crate::App`]'s: until the next
/// [`crate::App::suspend`].
pub trait WindowSource: HasWindowHandle + HasDisplayHandle + Send + Sync {}

/// A window that several surfaces are made of, one after the other.
#[derive(Clone)]
pub struct SharedWindow(pub Arc<dyn WindowSource>);

impl HasWindowHandle for SharedWindow {
    fn window_handle(&self) -> Result<WindowHandle<'_>, HandleError> {
        self.0.window_handle()
    }
}

impl HasDisplayHandle for SharedWindow {
    fn display_handle(&self) -> Result<DisplayHandle<'_>, HandleError> {
        self.0.display_handle()
    }
}

/// A picture of the screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns and rows.
    pub size_px: [u32; 2],
    /// Red, green, blue and alpha, rows from the top.
    pub rgba: Vec<u8>,
}

/// What frames are painted on.
pub enum Canvas {
    /// A window's surface.
    Window {
        /// What shows it.
        surface: wgpu::Surface<'static>,
        /// As what.
        configuration: wgpu::SurfaceConfiguration,
    },
    /// A texture that somebody may read back.
    Texture(Texture),
}

/// Where one frame is painted.
pub enum Sheet {
    /// On a frame of a surface; whether the surface is to be configured anew after it.
    Window(SurfaceTexture, bool),
    /// On the texture.
    Texture,
}

/// Format of textures without a window.
const OFFSCREEN: TextureFormat = TextureFormat::Rgba8Unorm;

impl Canvas {
    /// On a window's surface.
    ///
    /// # Errors
    /// If the device cannot show anything there: in words.
    pub fn on_surface(surface: wgpu::Surface<'static>, gpu: &Gpu, size_px: [u32; 2]) -> Result<Self, String> {
        let capabilities = surface.get_capabilities(gpu.adapter());
        let format = format_of(&capabilities.formats);
        let format = format.ok_or_else(|| format!("{} has no format for this window", gpu.info().name))?;
        let configuration = configuration(&capabilities, format, within(gpu, size_px));
        surface.configure(gpu.device(), &configuration);
        Ok(Self::Window { surface, configuration })
    }

    /// On a texture of that size.
    pub fn offscreen(gpu: &Gpu, size_px: [u32; 2]) -> Self {
        let [width, height] = within(gpu, size_px);
        Self::Texture(gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("screen"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: OFFSCREEN,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        }))
    }

    /// Its format.
    pub fn format(&self) -> TextureFormat {
        match self {
            Self::Window { configuration, .. } => configuration.format,
            Self::Texture(texture) => texture.format(),
        }
    }

    /// Its columns and rows.
    pub fn size_px(&self) -> [u32; 2] {
        match self {
            Self::Window { configuration, .. } => [configuration.width, configuration.height],
            Self::Texture(texture) => [texture.width(), texture.height()],
        }
    }

    /// Where the next frame is painted; none if there is nothing now, and the surface is gone if the error says so.
    pub fn next(&self, gpu: &Gpu) -> Result<Option<Sheet>, SurfaceLost> {
        let Self::Window { surface, .. } = self else { return Ok(Some(Sheet::Texture)) };
        let mut got = surface.get_current_texture();
        if Status::of(&got) == Status::Outdated {
            drop(got);
            self.configure(gpu);
            got = surface.get_current_texture();
        }
        let status = Status::of(&got);
        match got {
            Got::Success(texture) | Got::Suboptimal(texture) => {
                Ok(Some(Sheet::Window(texture, status == Status::Suboptimal)))
            }
            _ if status == Status::Lost => Err(SurfaceLost),
            _ => Ok(None),
        }
    }

    /// What a frame is painted to.
    pub fn view(&self, sheet: &Sheet) -> Option<TextureView> {
        let texture = match (sheet, self) {
            (Sheet::Window(frame, _), _) => &frame.texture,
            (Sheet::Texture, Self::Texture(texture)) => texture,
            (Sheet::Texture, Self::Window { .. }) => return None,
        };
        Some(texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }

    /// Shows what was painted.
    pub fn show(&self, gpu: &Gpu, sheet: Sheet) {
        if let Sheet::Window(frame, is_suboptimal) = sheet {
            gpu.queue().present(frame);
            if is_suboptimal {
                self.configure(gpu);
            }
        }
    }

    /// What was painted last; none of a window.
    pub fn read(&self, gpu: &Gpu) -> Option<Picture> {
        let Self::Texture(texture) = self else { return None };
        let [width, height] = self.size_px();
        let row_bytes = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("screen"),
            size: u64::from(row_bytes) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder =
            gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("screen") });
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row_bytes), rows_per_image: None };
        let to = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), to, texture.size());
        gpu.queue().submit([encoder.finish()]);
        buffer.map_async(wgpu::MapMode::Read, .., |_| ());
        gpu.device().poll(wgpu::PollType::wait_indefinitely()).ok()?;
        let rows = buffer.get_mapped_range(..).ok()?;
        let row = |row: &[u8]| row[..4 * width as usize].to_vec();
        Some(Picture { size_px: [width, height], rgba: rows.chunks_exact(row_bytes as usize).flat_map(row).collect() })
    }

    fn configure(&self, gpu: &Gpu) {
        if let Self::Window { surface, configuration } = self {
            surface.configure(gpu.device(), configuration);
        }
    }
}

/// The surface is gone: another has to be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceLost;

/// A size that the device has textures of: systems say 0 of windows that are not there yet.
fn within(gpu: &Gpu, size_px: [u32; 2]) -> [u32; 2] {
    let most = gpu.device().limits().max_texture_dimension_2d;
    size_px.map(|side| side.clamp(1, most))
}
