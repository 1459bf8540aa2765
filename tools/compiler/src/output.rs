//! Puts generated files in place: all or none, one build at a time.

use std::fs::File;
use std::path::{Path, PathBuf};

use crate::build::Files;
use crate::problem::{Problem, io_problem};

/// The folders that hold nothing but generated files.
const OWNED: [&str; 2] = ["src/generated", "spirv"];

/// Keeps other builds out until it is dropped.
pub struct Lock(#[allow(dead_code)] File);

/// Waits until no other build is at work on `target`.
pub fn lock(target: &Path) -> Result<Lock, Problem> {
    let path = target.join("shaders").join("lock");
    let folder = target.join("shaders");
    std::fs::create_dir_all(&folder).map_err(|error| io_problem("create", &folder, &error))?;
    let file = File::create(&path).map_err(|error| io_problem("create", &path, &error))?;
    file.lock().map_err(|error| io_problem("lock", &path, &error))?;
    Ok(Lock(file))
}

/// The generated files of a crate, and the crate's folder.
#[derive(Clone, Copy)]
pub struct Output<'a> {
    /// The folder.
    pub folder: &'a Path,
    /// What belongs into it.
    pub files: &'a Files,
}

impl Output<'_> {
    /// A path below the folder as people are told it: from the folder's own name on.
    fn shown(&self, path: &str) -> String {
        shown(self.folder, path)
    }

    /// Paths of files that are not there as they should be.
    fn changed(&self) -> Vec<&str> {
        let is_there = |path: &str, bytes: &Vec<u8>| std::fs::read(self.folder.join(path)).ok().as_ref() == Some(bytes);
        let changed = self.files.iter().filter(|(path, bytes)| !is_there(path, bytes));
        changed.map(|(path, _)| path.as_str()).collect()
    }

    /// Where a file lies until all are written.
    fn unfinished(&self, path: &str) -> PathBuf {
        PathBuf::from(format!("{}.tmp", self.folder.join(path).display()))
    }

    fn write_unfinished(&self, path: &str) -> Result<(), Problem> {
        let to = self.unfinished(path);
        if let Some(parent) = to.parent() {
            std::fs::create_dir_all(parent).map_err(|error| io_problem("create", parent, &error))?;
        }
        std::fs::write(&to, &self.files[path]).map_err(|error| io_problem("write", &to, &error))
    }
}

/// A path below a crate's folder, from the folder's own name on: `kernels/spirv/predict.spv`.
pub fn shown(folder: &Path, path: &str) -> String {
    let name = folder.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
    format!("{name}/{path}")
}

/// Replaces what changed and removes what is no longer generated. Every new file is written under
/// another name first, so that a full disk leaves the old files whole. Gives what changed.
pub fn replace(outputs: &[Output<'_>]) -> Result<Vec<String>, Problem> {
    let changed: Vec<(Output<'_>, &str)> =
        outputs.iter().flat_map(|output| output.changed().into_iter().map(|path| (*output, path))).collect();
    if let Err(problem) = changed.iter().try_for_each(|(output, path)| output.write_unfinished(path)) {
        for (output, path) in &changed {
            let _ = std::fs::remove_file(output.unfinished(path));
        }
        return Err(problem);
    }
    // The manifest last (m sorts before s): until it is there, the tests call the rest stale.
    for (output, path) in changed.iter().rev() {
        let to = output.folder.join(path);
        std::fs::rename(output.unfinished(path), &to).map_err(|error| io_problem("write", &to, &error))?;
    }
    let mut report: Vec<String> = changed.iter().map(|(output, path)| output.shown(path)).collect();
    for output in outputs {
        for path in strays(output) {
            let stray = output.folder.join(&path);
            std::fs::remove_file(&stray).map_err(|error| io_problem("remove", &stray, &error))?;
            report.push(output.shown(&path));
        }
    }
    Ok(report)
}

/// What differs between a crate's folder and what belongs into it, in words.
pub fn differences(output: &Output<'_>) -> Vec<String> {
    let mut differences = Vec::new();
    for (path, bytes) in output.files {
        match std::fs::read(output.folder.join(path)) {
            Ok(there) if there == *bytes => {}
            Ok(_) => differences.push(format!("{} is stale", output.shown(path))),
            Err(_) => differences.push(format!("{} is missing", output.shown(path))),
        }
    }
    let strays = strays(output).into_iter();
    differences.extend(strays.map(|path| format!("{} is no longer generated", output.shown(&path))));
    differences
}

/// Files in the generated folders that are not among those that belong there.
fn strays(output: &Output<'_>) -> Vec<String> {
    let mut strays = Vec::new();
    for owned in OWNED {
        let Ok(entries) = std::fs::read_dir(output.folder.join(owned)) else { continue };
        for entry in entries.flatten() {
            let path = format!("{owned}/{}", entry.file_name().to_string_lossy());
            if !output.files.contains_key(&path) && entry.path().is_file() {
                strays.push(path);
            }
        }
    }
    strays.sort();
    strays
}
