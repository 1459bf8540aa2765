//! What is wrong with a shader, said so that it can be found and mended.

use std::fmt;
use std::path::Path;

/// A place in a source file: its path below the shader folder, and the line counted from 1.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Path below the shader folder, with forward slashes.
    pub file: String,
    /// Line, counted from 1.
    pub line: u32,
}

/// One thing that stops a build.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where it is, if it is in a source file.
    pub place: Option<Place>,
    /// The kernels it was met in, with the keywords that were on; may be empty.
    pub kernels: Vec<String>,
    /// What is wrong.
    pub message: String,
    /// What to do about it, if that is known.
    pub way_out: Option<String>,
}

impl Problem {
    /// A problem with no place in a source file.
    pub fn new(message: impl Into<String>) -> Self {
        Self { place: None, kernels: Vec::new(), message: message.into(), way_out: None }
    }
    /// Names the place.
    pub fn at(mut self, file: impl Into<String>, line: u32) -> Self {
        self.place = Some(Place { file: file.into(), line });
        self
    }
    /// Names the place, if it was found.
    pub fn at_place(mut self, place: Option<Place>) -> Self {
        self.place = place;
        self
    }
    /// Names the kernel it was met in.
    pub fn kernel(mut self, kernel: impl Into<String>) -> Self {
        self.kernels.push(kernel.into());
        self
    }
    /// Says what to do about it.
    pub fn way_out(mut self, way_out: impl Into<String>) -> Self {
        self.way_out = Some(way_out.into());
        self
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(f, "{}:{}: ", place.file, place.line)?;
        }
        match self.kernels.as_slice() {
            [] => {}
            [one] => write!(f, "kernel {one}: ")?,
            [first, rest @ ..] => write!(f, "kernel {first} and {} more: ", rest.len())?,
        }
        write!(f, "{}", self.message)?;
        if let Some(way_out) = &self.way_out {
            write!(f, "\n    way out: {way_out}")?;
        }
        Ok(())
    }
}

/// Everything that stopped a build; nothing was written.
#[derive(Debug, thiserror::Error)]
pub struct Problems(pub Vec<Problem>);

impl Problems {
    /// The same problems with their files named from `folder` on, as a person would open them.
    pub fn below(mut self, folder: &Path) -> Self {
        for problem in &mut self.0 {
            if let Some(place) = &mut problem.place {
                place.file = folder.join(&place.file).display().to_string();
            }
        }
        self
    }
    /// Joins equal problems met in several kernels into one that names them all.
    pub fn merged(self) -> Self {
        let mut merged: Vec<Problem> = Vec::new();
        for problem in self.0 {
            let same = merged.iter_mut().find(|other| {
                other.place == problem.place && other.message == problem.message && other.way_out == problem.way_out
            });
            match same {
                Some(other) => {
                    for kernel in problem.kernels {
                        if !other.kernels.contains(&kernel) {
                            other.kernels.push(kernel);
                        }
                    }
                }
                None => merged.push(problem),
            }
        }
        Self(merged)
    }
}

impl From<Problem> for Problems {
    fn from(problem: Problem) -> Self {
        Self(vec![problem])
    }
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problem) in self.0.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "error: {problem}")?;
        }
        Ok(())
    }
}

/// `Problem`s from input and output: what was attempted on which file, and what the system said.
pub fn io_problem(doing: &str, path: &Path, error: &std::io::Error) -> Problem {
    Problem::new(format!("cannot {doing} {}: {error}", path.display()))
}
