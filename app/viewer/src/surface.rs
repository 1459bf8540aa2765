//! The window's surface: what it is configured to, and what to do when a frame does not come.

use wgpu::CurrentSurfaceTexture as Got;

/// What can be done with a frame of the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Paint it.
    Good,
    /// Paint it; configure the surface before the next one.
    Suboptimal,
    /// Nothing to paint on now: ask again later.
    Later,
    /// Configure the surface, and ask again.
    Outdated,
    /// The surface is gone: make another.
    Lost,
}

impl Status {
    /// What wgpu's answer means.
    pub fn of(got: &Got) -> Self {
        match got {
            Got::Success(_) => Self::Good,
            Got::Suboptimal(_) => Self::Suboptimal,
            Got::Timeout | Got::Occluded => Self::Later,
            Got::Outdated | Got::Validation => Self::Outdated,
            Got::Lost => Self::Lost,
        }
    }
}

/// The format for windows of a surface: one that takes display colours as they are, as pictures are.
pub fn format_of(formats: &[wgpu::TextureFormat]) -> Option<wgpu::TextureFormat> {
    let plain = |format: &&wgpu::TextureFormat| {
        matches!(format, wgpu::TextureFormat::Bgra8Unorm | wgpu::TextureFormat::Rgba8Unorm)
    };
    formats.iter().find(plain).or_else(|| formats.first()).copied()
}

/// Its configuration for a window of a size.
pub fn configuration(
    capabilities: &wgpu::SurfaceCapabilities,
    format: wgpu::TextureFormat,
    size_px: [u32; 2],
) -> wgpu::SurfaceConfiguration {
    wgpu::SurfaceConfiguration {
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        format,
        width: size_px[0].max(1),
        height: size_px[1].max(1),
        present_mode: wgpu::PresentMode::AutoVsync,
        // One frame waits for the display: more would only make the picture older.
        desired_maximum_frame_latency: 1,
        alpha_mode: capabilities.alpha_modes.first().copied().unwrap_or_default(),
        view_formats: Vec::new(),
        color_space: Default::default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_surface_without_srgb_encoding_is_taken_where_there_is_one() {
        use wgpu::TextureFormat as F;
        assert_eq!(format_of(&[F::Bgra8UnormSrgb, F::Bgra8Unorm]), Some(F::Bgra8Unorm));
        assert_eq!(format_of(&[F::Rgba16Float]), Some(F::Rgba16Float));
        assert_eq!(format_of(&[]), None);
    }

    #[test]
    fn each_answer_has_its_remedy() {
        let answers = [Got::Timeout, Got::Occluded, Got::Outdated, Got::Validation, Got::Lost];
        let remedies = answers.map(|got| Status::of(&got));
        assert_eq!(remedies, [Status::Later, Status::Later, Status::Outdated, Status::Outdated, Status::Lost]);
    }
}
