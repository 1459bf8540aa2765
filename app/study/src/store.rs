//! Outcomes as they come: a line of JSON each, in a file that a killed study goes on with.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, ErrorKind, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::{Outcome, Task};

/// Name of the file in a study's folder.
pub const RESULTS: &str = "results.jsonl";

/// Why outcomes cannot be kept or read.
#[derive(Debug, Error)]
pub enum StoreError {
    /// Reading or writing failed.
    #[error("{path}: {reason}")]
    File {
        /// The file.
        path: String,
        /// What the system says.
        reason: String,
    },
    /// A file of another kind.
    #[error("{path}: holds no outcomes of a study: line {line}: {reason}")]
    Foreign {
        /// The file.
        path: String,
        /// Which line, from 1.
        line: usize,
        /// What was expected.
        reason: String,
    },
}

/// A line.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Line {
    program: String,
    task: Task,
    outcome: Outcome,
}

/// The outcomes of a study, by their tasks' keys.
pub struct Store {
    path: PathBuf,
    program: String,
    outcomes: BTreeMap<String, Outcome>,
    others: usize,
    file: Option<File>,
}

impl Store {
    /// Opens the outcomes in a folder, or begins them. Those of another program version stay in the file
    /// and are not taken.
    ///
    /// # Errors
    /// If the file cannot be read, or holds something else.
    pub fn open(folder: &Path, program: &str) -> Result<Self, StoreError> {
        let path = folder.join(RESULTS);
        let mut store = Self { path, program: program.into(), outcomes: BTreeMap::new(), others: 0, file: None };
        let (path, fail) = (store.path.clone(), |error: &std::io::Error| failed(&folder.join(RESULTS), error));
        match File::open(&path) {
            Ok(file) => {
                let (lines, whole_bytes) = read(&path, file)?;
                for line in lines {
                    if line.program == store.program {
                        store.outcomes.insert(line.task.key(&store.program), line.outcome);
                    } else {
                        store.others += 1;
                    }
                }
                // A kill may leave half a line: it is cut off, so that the next does not join it.
                let file = OpenOptions::new().write(true).open(&path).map_err(|error| fail(&error))?;
                file.set_len(whole_bytes).map_err(|error| fail(&error))?;
            }
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            Err(error) => return Err(fail(&error)),
        }
        Ok(store)
    }

    /// Takes the outcomes of another folder, too: a part that ran elsewhere. Returns how many were new.
    ///
    /// # Errors
    /// If there are none, the file cannot be read, or what is taken cannot be kept.
    pub fn merge(&mut self, folder: &Path) -> Result<usize, StoreError> {
        let path = folder.join(RESULTS);
        let file = File::open(&path).map_err(|error| failed(&path, &error))?;
        let (lines, _) = read(&path, file)?;
        let mut taken = 0;
        for line in lines {
            if line.program != self.program {
                self.others += 1;
            } else if self.get(&line.task).is_none() {
                self.put(&line.task, line.outcome)?;
                taken += 1;
            }
        }
        Ok(taken)
    }

    /// What came of a task, if it ran.
    pub fn get(&self, task: &Task) -> Option<&Outcome> {
        self.outcomes.get(&task.key(&self.program))
    }

    /// Outcomes in the file that another version of the program left there.
    pub fn of_other_versions(&self) -> usize {
        self.others
    }

    /// Keeps an outcome; on the disk when this returns.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn put(&mut self, task: &Task, outcome: Outcome) -> Result<(), StoreError> {
        let line = Line { program: self.program.clone(), task: task.clone(), outcome };
        let mut text = serde_json::to_vec(&line).map_err(|error| failed(&self.path, &error.into()))?;
        text.push(b'\n');
        let path = &self.path;
        let file = match &mut self.file {
            Some(file) => file,
            none => {
                let open = OpenOptions::new().create(true).append(true).open(path);
                none.insert(open.map_err(|error| failed(path, &error))?)
            }
        };
        file.write_all(&text).and_then(|()| file.flush()).map_err(|error| failed(path, &error))?;
        self.outcomes.insert(task.key(&self.program), line.outcome);
        Ok(())
    }
}

/// Whole lines, and how many bytes they are.
fn read(path: &Path, file: File) -> Result<(Vec<Line>, u64), StoreError> {
    let mut reader = BufReader::new(file);
    let (mut lines, mut whole_bytes) = (Vec::new(), 0);
    for number in 1.. {
        let mut text = Vec::new();
        let read = reader.read_until(b'\n', &mut text).map_err(|error| failed(path, &error))?;
        if read == 0 || text.last() != Some(&b'\n') {
            break;
        }
        lines.push(serde_json::from_slice(&text).map_err(|error| StoreError::Foreign {
            path: path.display().to_string(),
            line: number,
            reason: error.to_string(),
        })?);
        whole_bytes += read as u64;
    }
    Ok((lines, whole_bytes))
}

fn failed(path: &Path, error: &std::io::Error) -> StoreError {
    StoreError::File { path: path.display().to_string(), reason: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;

    fn task(case: &str) -> Task {
        Task { part: "error".into(), case: case.into(), settings: Vec::new(), tier: "desktop".into(), repeats: 1 }
    }

    #[test]
    fn what_was_kept_is_there_again_and_half_a_line_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Store::open(folder.path(), "1").unwrap();
        store.put(&task("a"), Outcome::empty(State::Stable, "x")).unwrap();
        store.put(&task("b"), Outcome::empty(State::NotRun, "y")).unwrap();
        let path = folder.path().join(RESULTS);
        let text = std::fs::read(&path).unwrap();
        std::fs::write(&path, &text[..text.len() - 10]).unwrap();
        let mut again = Store::open(folder.path(), "1").unwrap();
        assert_eq!(again.get(&task("a")).unwrap().reason, "x");
        assert!(again.get(&task("b")).is_none());
        again.put(&task("c"), Outcome::empty(State::Stable, "z")).unwrap();
        let again = Store::open(folder.path(), "1").unwrap();
        assert!(again.get(&task("a")).is_some() && again.get(&task("c")).is_some());
    }

    #[test]
    fn another_versions_outcomes_are_counted_and_not_taken() {
        let folder = tempfile::tempdir().unwrap();
        Store::open(folder.path(), "1").unwrap().put(&task("a"), Outcome::empty(State::Stable, "")).unwrap();
        let store = Store::open(folder.path(), "2").unwrap();
        assert!(store.get(&task("a")).is_none());
        assert_eq!(store.of_other_versions(), 1);
    }

    #[test]
    fn parts_are_joined_and_a_foreign_file_is_named() {
        let (one, two) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let mut store = Store::open(one.path(), "1").unwrap();
        store.put(&task("a"), Outcome::empty(State::Stable, "")).unwrap();
        Store::open(two.path(), "1").unwrap().put(&task("b"), Outcome::empty(State::Stable, "")).unwrap();
        assert_eq!(store.merge(two.path()).unwrap(), 1);
        assert!(store.get(&task("a")).is_some() && store.get(&task("b")).is_some());
        std::fs::write(two.path().join(RESULTS), "{\"x\": 1}\n").unwrap();
        let error = store.merge(two.path()).unwrap_err().to_string();
        assert!(error.contains("line 1") && error.contains(RESULTS), "{error}");
        assert!(store.merge(&two.path().join("none")).is_err());
    }
}
