//! Why the program ends early: one line for the person, one code for the script.

use std::{fmt, process::ExitCode};

/// An end before the end.
#[derive(Debug)]
pub enum Failure {
    /// What was asked for is wrong, or this machine cannot do it at all.
    Input(String),
    /// It began, and could not go on.
    Stopped(String),
    /// Ctrl-C; what is said is what was kept.
    Interrupted(String),
}

impl Failure {
    /// A mistake of the input, from whatever found it.
    pub fn input(error: impl fmt::Display) -> Self {
        Self::Input(error.to_string())
    }

    /// An end halfway, from whatever caused it.
    pub fn stopped(error: impl fmt::Display) -> Self {
        Self::Stopped(error.to_string())
    }

    /// What is said, without what kind of end it is.
    pub fn text(&self) -> &str {
        match self {
            Self::Input(text) | Self::Stopped(text) | Self::Interrupted(text) => text,
        }
    }

    /// The code for the shell.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Stopped(_) => ExitCode::from(1),
            Self::Input(_) => ExitCode::from(2),
            Self::Interrupted(_) => ExitCode::from(130),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(_) | Self::Stopped(_) => write!(f, "error: {}", self.text()),
            Self::Interrupted(_) => write!(f, "interrupted: {}", self.text()),
        }
    }
}
