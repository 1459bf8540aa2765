//! What can be wrong with a view or a picture, in one line that names the field, the value and
//! what is allowed.

use std::path::PathBuf;

/// A picture that cannot be drawn or written.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// A value outside what is allowed.
    #[error("{field} = {value}: {allowed}")]
    NotAllowed {
        /// Name of the field.
        field: &'static str,
        /// The value given.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The pixels are not as many as the size says.
    #[error("a picture of {width_px} x {height_px} pixels has {wanted} bytes, {got} were given")]
    PixelCount {
        /// Width in pixels.
        width_px: u32,
        /// Height in pixels.
        height_px: u32,
        /// Bytes such a picture has.
        wanted: usize,
        /// Bytes given.
        got: usize,
    },
    /// The file could not be written.
    #[error("picture {}: cannot be written: {reason}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system says.
        reason: String,
    },
}

impl RenderError {
    /// `field` has a value that is not allowed.
    pub(crate) fn not_allowed(field: &'static str, value: impl std::fmt::Debug, allowed: &'static str) -> Self {
        Self::NotAllowed { field, value: format!("{value:?}"), allowed }
    }
}
