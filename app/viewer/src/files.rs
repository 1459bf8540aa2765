//! Names of what the window writes: never one that is taken.

use std::path::{Path, PathBuf};

/// `folder/name_0001.ending`, or the first number after it that is free.
pub fn free_name(folder: &Path, name: &str, ending: &str) -> PathBuf {
    let numbered = |number: u32| folder.join(format!("{name}_{number:04}.{ending}"));
    (1..).map(numbered).find(|path| !path.exists()).unwrap_or_else(|| numbered(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_taken_is_not_given() {
        let folder = std::env::temp_dir().join(format!("brooklet-names-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let first = free_name(&folder, "shot", "png");
        assert!(first.ends_with("shot_0001.png"));
        std::fs::write(&first, []).unwrap();
        assert!(free_name(&folder, "shot", "png").ends_with("shot_0002.png"));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
