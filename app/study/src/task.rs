//! One run of a study as plain data: what it is, and what came of it.

use std::fmt::Write as _;

use brooklet_gpu::{Tier, tier_name};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::Figure;

/// One run: a case with settings.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Task {
    /// Which part of the study asks for it: `error`, `validation`, `stability`, `map`, `reference`.
    pub part: String,
    /// Name of the case.
    pub case: String,
    /// What is changed of it, each as `path=value`.
    pub settings: Vec<String>,
    /// Tier the device is used as.
    pub tier: String,
    /// How often it is run; errors are the first run's, times all runs'.
    pub repeats: u32,
}

/// How it ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum State {
    /// Sound to the end, and within its case's bounds.
    Stable,
    /// Sound, and the program counted that it had to cut something short.
    Clamped,
    /// Not sound or beyond its bounds, and the program's own measurements say so.
    Unstable,
    /// Not sound or beyond its bounds, and nothing the program measures says so: a defect.
    Silent,
    /// Refused with a reason, before it ran.
    Refused,
    /// Could not be run here.
    NotRun,
}

impl State {
    /// As tables say it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Clamped => "clamped, said",
            Self::Unstable => "unstable, said",
            Self::Silent => "SILENT",
            Self::Refused => "refused, said",
            Self::NotRun => "not run",
        }
    }
}

/// What a run cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Cost {
    /// GPU seconds a simulated second: the median step over its length.
    pub median_s_per_s: f64,
    /// The same of the step that 95 of 100 do not exceed.
    pub p95_s_per_s: f64,
    /// Steps that were timed, after the warm-up.
    pub timed_steps: u64,
    /// Whether the GPU's own clock says so; else the host's.
    pub gpu_clock: bool,
    /// Bytes of GPU memory that the plan keeps.
    pub bytes: u64,
}

/// A quantity over time, beside what it is held against.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// What it is.
    pub name: String,
    /// Label of the time's axis.
    pub x: String,
    /// Label of the quantity's axis.
    pub y: String,
    /// What the run gave.
    pub computed: Vec<(f64, f64)>,
    /// What it is held against.
    pub reference: Vec<(f64, f64)>,
    /// Whether the reference is a measurement: points, not a line.
    pub measured: bool,
}

/// What came of a task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// How it ended.
    pub state: State,
    /// Why it was refused, not run, or found unstable.
    pub reason: String,
    /// What it is judged by; the first is its case's error.
    pub figures: Vec<Figure>,
    /// What it cost; none if nothing was timed.
    pub cost: Option<Cost>,
    /// Number of particles.
    pub particles: u64,
    /// Courses in time that plots show.
    #[serde(default)]
    pub series: Vec<Series>,
    /// GPU milliseconds of steps spread over the run, at most some two hundred.
    pub step_ms: Vec<f64>,
    /// Which device.
    pub device: String,
    /// Seconds the task took, all of it.
    pub wall_s: f64,
}

impl Outcome {
    /// Nothing but a reason.
    pub fn empty(state: State, reason: impl Into<String>) -> Self {
        Self {
            state,
            reason: reason.into(),
            figures: Vec::new(),
            cost: None,
            particles: 0,
            series: Vec::new(),
            step_ms: Vec::new(),
            device: String::new(),
            wall_s: 0.0,
        }
    }

    /// The case's error: its first figure.
    pub fn error(&self) -> Option<f64> {
        self.figures.first()?.value
    }

    /// A figure by its name.
    pub fn figure(&self, name: &str) -> Option<&Figure> {
        self.figures.iter().find(|figure| figure.name == name)
    }
}

impl Task {
    /// What tells this task from all others, and from the same task of another program version.
    pub fn key(&self, program: &str) -> String {
        let mut hash = Sha256::new();
        hash.update(program);
        for text in [&self.part, &self.case, &self.tier, &self.repeats.to_string()] {
            hash.update([0]);
            hash.update(text);
        }
        for setting in &self.settings {
            hash.update([1]);
            hash.update(setting);
        }
        hex(&hash.finalize()[..12])
    }

    /// In one line.
    pub fn describe(&self) -> String {
        let mut text = self.case.clone();
        for setting in &self.settings {
            let _ = write!(text, " {setting}");
        }
        if self.tier != tier_name(Tier::Desktop) {
            let _ = write!(text, " ({})", self.tier);
        }
        text
    }
}

/// Bytes in hexadecimal.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_tell_tasks_apart() {
        let task = Task {
            part: "error".into(),
            case: "drop".into(),
            settings: vec!["a=1".into(), "b=2".into()],
            tier: "desktop".into(),
            repeats: 1,
        };
        let key = task.key("1");
        assert_eq!(key, task.clone().key("1"));
        let others = [
            Task { part: "map".into(), ..task.clone() },
            Task { settings: vec!["a=1b=2".into()], ..task.clone() },
            Task { settings: vec!["b=2".into(), "a=1".into()], ..task.clone() },
            Task { tier: "floor".into(), ..task.clone() },
            Task { repeats: 2, ..task.clone() },
        ];
        assert!(others.iter().all(|other| other.key("1") != key));
        assert_ne!(task.key("2"), key);
    }
}
