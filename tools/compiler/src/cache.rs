//! Files kept between runs.

use std::path::Path;

/// Puts a file into a cache whole or not at all; a cache that cannot be written is only slow.
pub fn keep(path: &Path, bytes: &[u8]) {
    let unfinished = path.with_extension(format!("{}-{:?}.tmp", std::process::id(), std::thread::current().id()));
    if std::fs::write(&unfinished, bytes).is_ok() {
        let _ = std::fs::rename(&unfinished, path);
    }
}
