//! What the scaling table holds: plain data, which the report, the plot and the targets read.

use brooklet_gpu::{PassTimes, Passes, Quantiles};
use serde::Serialize;

pub use crate::traffic::Traffic;
use crate::{
    bounds::{Bounds, Limit},
    rates::Rates,
    workload::Load,
};

/// The whole table.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    /// What it ran on.
    pub device: String,
    /// `cpu` of a driver that runs on the processor.
    pub device_type: String,
    /// The driver and its version.
    pub driver: String,
    /// What the device was used as.
    pub tier: &'static str,
    /// What it can do at most.
    pub rates: Rates,
    /// By size, then by load.
    pub rows: Vec<Row>,
    /// Sizes without a row.
    pub left_out: Vec<LeftOut>,
    /// Each target for which there are rows.
    pub targets: Vec<Verdict>,
}

/// One load at one size.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Number of particles.
    pub particles: u32,
    /// What is solved.
    #[serde(skip)]
    pub load: Load,
    /// The same in words.
    pub terms: &'static str,
    /// All iterations of a step.
    pub iterations: u32,
    /// Steps that were timed.
    pub steps: u64,
    /// From the first pass of a step to the end of its last, clears between them included, ms.
    pub step_ms: Quantiles,
    /// A measurement's part in a step, with the scene's interval between two of them, ms.
    pub measure_ms: f64,
    /// Particles times iterations a second, measuring included.
    pub particle_iterations_per_s: f64,
    /// What one of them takes, ns.
    pub ns_per_particle_iteration: f64,
    /// Of GPU memory.
    pub bytes: u64,
    /// The same over the particles.
    pub bytes_per_particle: f64,
    /// Listed neighbours a particle at the end.
    pub neighbours_mean: f64,
    /// Counting, prefix sums and reordering, over the step.
    pub grid_share: f64,
    /// The pass that takes the most milliseconds above its bound.
    pub furthest_from_bound: Option<&'static str>,
    /// In order of their first run.
    pub passes: Passes<Pass>,
    /// Spans that cannot be right.
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
    /// Its times.
    #[serde(flatten)]
    pub times: PassTimes,
    /// Its part in the row's figure; of a measurement with the interval counted in, ns.
    pub ns_per_particle_iteration: f64,
    /// What it moves.
    #[serde(flatten)]
    pub traffic: Traffic,
    /// Compulsory bytes over the median, 1e9 bytes a second.
    pub gb_per_s: f64,
    /// Compulsory and gathered bytes over the median, 1e9 bytes a second.
    pub gb_per_s_gathers_too: f64,
    /// The least time by each of the device's rates.
    pub bounds: Bounds,
    /// The one of them that is nearest.
    pub nearest: Limit,
    /// That least time, ms.
    pub bound_ms: f64,
    /// The same over the median: 1 at the bound.
    pub share_of_bound: f64,
}

/// A size that is not in the table.
#[derive(Clone, Debug, Serialize)]
pub struct LeftOut {
    /// Number of particles.
    pub particles: u32,
    /// Why.
    pub reason: String,
}

/// A target and what was measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// What is measured, and on which rows.
    pub name: String,
    /// What it is to be.
    pub target: f64,
    /// What it is.
    pub measured: f64,
    /// Whether it is met.
    pub met: bool,
    /// Whether the measured value has to be at least the target; else at most.
    pub at_least: bool,
}
