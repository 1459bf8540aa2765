//! What the scaling table holds: plain data, which the report, the plot and the targets read.

use brooklet_gpu::{PassTimes, Passes, Quantiles};
use serde::Serialize;

use super::{traffic::Traffic, workload::Load};

/// The whole table.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    pub device: String,
    pub device_type: String,
    pub driver: String,
    pub tier: &'static str,
    pub commit: &'static str,
    /// What a copy of a large buffer reads and writes in a second.
    pub copy_gb_per_s: f64,
    pub rows: Vec<Row>,
    pub left_out: Vec<LeftOut>,
    pub targets: Vec<Verdict>,
}

/// One load at one size.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub particles: u32,
    #[serde(skip)]
    pub load: Load,
    pub terms: &'static str,
    /// All iterations of a step.
    pub iterations: u32,
    /// Steps that were timed.
    pub steps: u64,
    /// From the first pass of a step to the end of its last, clears between them included.
    pub step_ms: Quantiles,
    /// A measurement's part in a step, with the scene's interval between two of them.
    pub measure_ms: f64,
    pub particle_iterations_per_s: f64,
    pub ns_per_particle_iteration: f64,
    pub bytes: u64,
    pub bytes_per_particle: f64,
    pub neighbours_mean: f64,
    /// Counting, prefix sums and reordering, over the step.
    pub grid_share: f64,
    /// The pass that takes the most milliseconds above its bound.
    pub furthest_from_bound: Option<&'static str>,
    pub passes: Passes<Pass>,
    pub flagged_spans: u64,
}

impl Row {
    /// Whether the row is `load`'s.
    pub fn is_of(&self, load: Load) -> bool {
        self.load == load
    }
}

/// A pass of a row.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Pass {
    #[serde(flatten)]
    pub times: PassTimes,
    /// Its part in the row's figure; of a measurement with the interval counted in.
    pub ns_per_particle_iteration: f64,
    #[serde(flatten)]
    pub traffic: Traffic,
    /// Compulsory bytes over the median.
    pub gb_per_s: f64,
    /// Compulsory and gathered bytes over the median.
    pub gb_per_s_gathers_too: f64,
    /// What a copy of the compulsory bytes would take.
    pub bound_ms: f64,
    /// The median over that.
    pub times_its_bound: f64,
}

/// A size that is not in the table.
#[derive(Clone, Debug, Serialize)]
pub struct LeftOut {
    pub particles: u32,
    pub reason: String,
}

/// A target and what was measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    pub name: String,
    pub target: f64,
    pub measured: f64,
    pub met: bool,
    /// Whether the measured value has to be at least the target; else at most.
    pub at_least: bool,
}
