//! The run's pictures: from the GPU to files.

use std::path::Path;

use brooklet_gpu::Engine;
use brooklet_kernels::Texture;
use brooklet_render::{FramePasses, png};

use crate::failure::Failure;

/// A picture of the particles as they are on the GPU.
pub struct Picture<'a> {
    color: &'a Texture,
}

impl<'a> Picture<'a> {
    /// What `passes` draw.
    pub fn of(passes: &'a FramePasses) -> Self {
        Self { color: &passes.color }
    }

    /// Waits for the last picture that was drawn, and copies it to the host.
    pub fn read(&self, engine: &mut Engine) -> Result<Vec<u8>, Failure> {
        engine.read_texture(self.color).map_err(Failure::stopped)
    }

    /// Writes a picture that was read.
    pub fn save(&self, path: &Path, rgba: &[u8]) -> Result<(), Failure> {
        png::save(path, self.color.size_px, rgba).map_err(Failure::stopped)
    }
}
