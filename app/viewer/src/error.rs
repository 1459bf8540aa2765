//! What can go wrong in the window, in words for the person before it.

use brooklet_gpu::GpuError;
use brooklet_render::{RenderError, ScenePlanError};

/// A scene that cannot be made, or cannot go on.
#[derive(Debug, thiserror::Error)]
pub enum ViewerError {
    /// The device.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The scene's plan.
    #[error(transparent)]
    Plan(#[from] ScenePlanError),
    /// What is drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The plan has no picture (a fault of this program).
    #[error("the scene's plan has no picture")]
    NoPicture,
    /// A shader that was compiled anew.
    #[error("shader {0}")]
    Shader(String),
    /// The system has no thread left.
    #[error("nothing can be built: {reason}")]
    NoThread {
        /// What the system says.
        reason: String,
    },
}

impl ViewerError {
    /// Whether the device is gone, and everything on it.
    pub fn is_device_lost(&self) -> bool {
        matches!(self, Self::Gpu(GpuError::DeviceLost { .. }))
    }
}
