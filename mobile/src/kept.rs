//! Files that are kept for the app's next start, or for its user to send.

use std::path::Path;

use serde::Serialize;

/// Writes `what` as JSON; a write that is cut short leaves the old file or none.
///
/// # Errors
/// If that cannot be written, with the file's name.
pub fn save(folder: &Path, file: &str, what: &impl Serialize) -> Result<(), String> {
    let path = folder.join(file);
    let failed = |error: std::io::Error| format!("{}: {error}", path.display());
    std::fs::create_dir_all(folder).map_err(failed)?;
    let text = serde_json::to_string_pretty(what).map_err(|error| format!("{}: {error}", path.display()))?;
    let unfinished = folder.join(format!("{file}.part"));
    std::fs::write(&unfinished, text).and_then(|()| std::fs::rename(&unfinished, &path)).map_err(failed)
}
