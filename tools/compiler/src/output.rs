//! Puts generated files in place: all or none, one build at a time.

use std::collections::BTreeSet;
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

/// Replaces what changed and removes what is no longer generated. Every new file is written under
/// another name first, so that a full disk leaves the old files whole. Gives what changed.
pub fn replace(folder: &Path, files: &Files) -> Result<Vec<String>, Problem> {
    let changed: Vec<&String> = files
        .iter()
        .filter(|(path, bytes)| std::fs::read(folder.join(path)).ok().as_ref() != Some(bytes))
        .map(|(path, _)| path)
        .collect();
    let unfinished = |path: &str| PathBuf::from(format!("{}.tmp", folder.join(path).display()));
    let written = changed.iter().try_for_each(|path| {
        let to = unfinished(path);
        if let Some(parent) = to.parent() {
            std::fs::create_dir_all(parent).map_err(|error| io_problem("create", parent, &error))?;
        }
        std::fs::write(&to, &files[*path]).map_err(|error| io_problem("write", &to, &error))
    });
    if let Err(problem) = written {
        for path in &changed {
            let _ = std::fs::remove_file(unfinished(path));
        }
        return Err(problem);
    }
    // The manifest last (m sorts before s): until it is there, the tests call the rest stale.
    for path in changed.iter().rev() {
        let to = folder.join(path);
        std::fs::rename(unfinished(path), &to).map_err(|error| io_problem("write", &to, &error))?;
    }
    let mut report: Vec<String> = changed.into_iter().cloned().collect();
    for path in strays(folder, files) {
        let stray = folder.join(&path);
        std::fs::remove_file(&stray).map_err(|error| io_problem("remove", &stray, &error))?;
        report.push(path);
    }
    Ok(report)
}

/// What differs between `folder` and `files`, in words.
pub fn differences(folder: &Path, files: &Files) -> Vec<String> {
    let mut differences = Vec::new();
    for (path, bytes) in files {
        match std::fs::read(folder.join(path)) {
            Ok(there) if there == *bytes => {}
            Ok(_) => differences.push(format!("{path} is stale")),
            Err(_) => differences.push(format!("{path} is missing")),
        }
    }
    differences.extend(strays(folder, files).into_iter().map(|path| format!("{path} is no longer generated")));
    differences
}

/// Files in the generated folders that are not among `files`.
fn strays(folder: &Path, files: &Files) -> Vec<String> {
    let known: BTreeSet<&str> = files.keys().map(String::as_str).collect();
    let mut strays = Vec::new();
    for owned in OWNED {
        let Ok(entries) = std::fs::read_dir(folder.join(owned)) else { continue };
        for entry in entries.flatten() {
            let path = format!("{owned}/{}", entry.file_name().to_string_lossy());
            if !known.contains(path.as_str()) && entry.path().is_file() {
                strays.push(path);
            }
        }
    }
    strays.sort();
    strays
}
