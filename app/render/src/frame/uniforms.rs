//! What the shaders are told of a picture.

use brooklet_kernels::{Buffer, FrameLight, FrameStyle, FrameView};

use super::look;
use super::options::FrameOptions;
use crate::{RenderError, View};

/// Camera, light and style on the GPU.
#[derive(Debug)]
pub struct FrameUniforms {
    /// The camera.
    pub view: Buffer<FrameView>,
    /// The sun, its shadow map and the sky.
    pub light: Buffer<FrameLight>,
    /// What is drawn and how it looks.
    pub style: Buffer<FrameStyle>,
}

/// What [`FrameUniforms`] hold for a view: what [`FramePasses::init`](super::FramePasses::init) uploads, and what a moving camera
/// writes before each picture (`engine.write(&uniforms.view, &[values.view])`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameValues {
    /// The camera.
    pub view: FrameView,
    /// The sun, its shadow map and the sky.
    pub light: FrameLight,
    /// What is drawn and how it looks.
    pub style: FrameStyle,
}

impl FrameValues {
    /// The values for a view.
    ///
    /// # Errors
    /// When the view or an option is not allowed; the error names it.
    pub fn new(view: &View, options: &FrameOptions) -> Result<Self, RenderError> {
        view.check()?;
        options.check()?;
        Ok(Self {
            view: look::frame_view(view, options),
            light: look::frame_light(view, options),
            style: look::frame_style(view, options),
        })
    }
}
