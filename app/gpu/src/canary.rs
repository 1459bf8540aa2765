//! Drivers crash while they build a pipeline, and take the program with them. So the name of the module about to be built is
//! written to a file first, which goes when it is built: a start that finds one knows what ended an earlier program.
//!
//! That module is then skipped. A program may also be killed while it builds, so after one such end the module is tried again
//! at the start after the next; after two it is skipped for as long as device and driver are the same.
//!
//! The files are not synced to the disk: they outlive the program, not the machine.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Ends while one module was built that skip it for good.
const TWICE: u32 = 2;

/// The files of one device and driver.
#[derive(Debug)]
pub(crate) struct Canary {
    /// Of this program: what it is building.
    own: PathBuf,
    /// Modules that ended a program while they were built, with how often.
    history: PathBuf,
}

/// A module that is skipped, and why.
pub(crate) type Skipped = BTreeMap<String, String>;

impl Canary {
    /// In `folder`, for the device and driver that `key` names; with it what ended earlier programs. Where the folder cannot
    /// be written nothing is known, and nothing is lost.
    pub fn open(folder: &Path, stem: &str, key: &str) -> (Self, Skipped) {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let own = folder.join(format!("{stem}.{}.{count}.building", std::process::id()));
        let canary = Self { own, history: folder.join(format!("{stem}.refused")) };
        let mut ends = canary.read_history(key);
        let mut skipped = Skipped::new();
        for module in left_behind(folder, stem) {
            *ends.entry(module.clone()).or_default() += 1;
            skipped.insert(module, "the program ended while the driver built it the last time".to_owned());
        }
        if !skipped.is_empty() {
            canary.write_history(key, &ends);
        }
        for (module, _) in ends.iter().filter(|(_, ends)| **ends >= TWICE) {
            let file = canary.history.display();
            let reason =
                format!("the program ended {TWICE} times while the driver built it; without {file} it is tried again");
            skipped.insert(module.clone(), reason);
        }
        (canary, skipped)
    }

    /// A driver is about to build `module`.
    pub fn building(&self, module: &str) {
        // What cannot be written is not known at the next start; this one goes on all the same.
        let folder = self.own.parent().unwrap_or(&self.own);
        let _ = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&self.own, module));
    }

    /// It came back.
    pub fn built(&self) {
        let _ = std::fs::remove_file(&self.own);
    }

    /// Lines of `count module`, after one that says what device and driver they are of.
    fn read_history(&self, key: &str) -> BTreeMap<String, u32> {
        let text = std::fs::read_to_string(&self.history).unwrap_or_default();
        let mut lines = text.lines();
        if lines.next() != Some(key) {
            return BTreeMap::new();
        }
        let entry = |line: &str| {
            let (count, module) = line.split_once(' ')?;
            Some((module.to_owned(), count.parse().ok()?))
        };
        lines.filter_map(entry).collect()
    }

    fn write_history(&self, key: &str, ends: &BTreeMap<String, u32>) {
        let mut text = format!("{key}\n");
        for (module, count) in ends {
            text.push_str(&format!("{count} {module}\n"));
        }
        let unfinished = self.own.with_extension("unfinished");
        let _ = std::fs::write(&unfinished, text).and_then(|()| std::fs::rename(&unfinished, &self.history));
    }
}

impl Drop for Canary {
    fn drop(&mut self) {
        self.built();
    }
}

/// What programs that are gone were building; their files go.
fn left_behind(folder: &Path, stem: &str) -> Vec<String> {
    let mut modules = Vec::new();
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let parts = name.to_str().and_then(|name| name.strip_prefix(stem)?.strip_suffix(".building"));
        let Some(pid) = parts.and_then(|parts| parts.strip_prefix('.')?.split('.').next()?.parse().ok()) else {
            continue;
        };
        if is_running(pid) {
            continue;
        }
        if let Ok(module) = std::fs::read_to_string(entry.path())
            && !module.is_empty()
        {
            modules.push(module);
        }
        let _ = std::fs::remove_file(entry.path());
    }
    modules
}

/// Whether a program of that number runs; where nobody tells, it is taken to be gone.
fn is_running(pid: u32) -> bool {
    pid == std::process::id() || Path::new("/proc").join(pid.to_string()).exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As a program that is gone would have left it: no process has this number.
    fn crash(folder: &Path, module: &str) {
        std::fs::write(folder.join(format!("device.{}.0.building", u32::MAX)), module).unwrap();
    }

    fn skipped(folder: &Path, key: &str) -> Vec<String> {
        Canary::open(folder, "device", key).1.into_keys().collect()
    }

    #[test]
    fn a_module_that_ended_the_program_is_skipped_once_and_after_the_second_time_for_good() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        assert_eq!(skipped(folder, "driver 1"), Vec::<String>::new());
        crash(folder, "Sum+WALLS");
        assert_eq!(skipped(folder, "driver 1"), ["Sum+WALLS"]);
        assert_eq!(skipped(folder, "driver 1"), Vec::<String>::new(), "it may have been killed: it is tried again");
        crash(folder, "Sum+WALLS");
        crash(folder, "Sum+WALLS");
        assert_eq!(skipped(folder, "driver 1"), ["Sum+WALLS"]);
        assert_eq!(skipped(folder, "driver 1"), ["Sum+WALLS"], "for good");
        assert_eq!(skipped(folder, "driver 2"), Vec::<String>::new(), "another driver may be mended");
    }

    #[test]
    fn one_that_runs_or_came_through_is_not_to_blame() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let (other, _) = Canary::open(folder, "device", "driver");
        other.building("Sum");
        assert_eq!(skipped(folder, "driver"), Vec::<String>::new(), "this program still runs");
        other.built();
        crash(folder, "");
        assert_eq!(skipped(folder, "driver"), Vec::<String>::new());
        drop(other);
        let left: Vec<_> = std::fs::read_dir(folder).unwrap().collect();
        assert!(left.is_empty(), "{left:?}");
    }

    #[test]
    fn a_torn_history_is_no_history() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("device.refused"), "driver\n2\nx Sum\n2 Other\n").unwrap();
        assert_eq!(skipped(folder.path(), "driver"), ["Other"]);
        std::fs::write(folder.path().join("device.refused"), [0xff, 0xfe]).unwrap();
        assert_eq!(skipped(folder.path(), "driver"), Vec::<String>::new());
    }
}
