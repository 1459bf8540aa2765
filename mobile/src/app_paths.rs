//! Where the app keeps what.

use std::path::PathBuf;

/// Folders of the app's own.
#[derive(Clone, Debug)]
pub struct AppPaths {
    /// Captures and pictures, where the user finds them.
    pub files: PathBuf,
    /// Compiled pipelines.
    pub cache: PathBuf,
}
