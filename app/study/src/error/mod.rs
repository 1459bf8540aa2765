//! Work-precision: error against GPU time, one knob a curve (the convention of SciML's benchmarks). A
//! point is a run of a case; what fails is a point, too. Kinds of reference are never merged.

mod equal_work;
mod jacobi;
mod order;
mod overhead;
mod points;

pub use equal_work::{equal_work_cost, equal_work_tasks, run_equal_work};
pub use jacobi::{Convergence, jacobi_tasks, run_jacobi};
pub use order::{ORDER_CASES, order_tasks, run_order};
pub use overhead::{overhead_tasks, run_overhead};
pub use points::{Curve, Point, curves, front};

use brooklet_gpu::tier_name;

use crate::backend::GpuRun;
use crate::case::{self, CASES, Case};
use crate::energy;
use crate::knob::knobs;
use crate::method::{METHODS, Method};
use crate::session::{Session, StudyError, state_of};
use crate::{Figure, Outcome, Setup, State, Task};

/// Part of a study: points of curves.
pub const PART: &str = "error";
/// Part of a study: whether f64 runs converge.
pub const ORDER_PART: &str = "order";
/// Part of a study: Jacobi against Gauss-Seidel.
pub const JACOBI_PART: &str = "jacobi";
/// Part of a study: iterations against substeps at equal work.
pub const EQUAL_WORK_PART: &str = "equal-work";

/// Part of a study: what timestamps, captures and measurements cost.
pub const OVERHEAD_PART: &str = "overhead";

/// Steps at the start whose times do not count: the device's clock rises and caches fill then.
const WARM_UP: usize = 10;

/// Which curves.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Cases by name; empty for all that can be drawn.
    pub cases: Vec<String>,
    /// Methods by name; empty for all, of costly ones few points ([`Method::few`]).
    pub methods: Vec<String>,
    /// Knobs by name; empty for all.
    pub knobs: Vec<String>,
    /// Few positions, one repeat.
    pub quick: bool,
}

/// Cases that a quick look takes: a closed form and a converged run. The experiment, which is long, is run once, to be
/// validated by.
const QUICK: [&str; 2] = ["elliptical-drop", "column-collapse"];
/// What a curve cannot be drawn of: exact, whatever is turned; or too large to be turned often.
const NO_CURVES: [&str; 3] = ["free-fall", "spheric-2", "spheric-10"];

impl Choice {
    /// Whether nothing was chosen: all curves, and what belongs to them.
    pub fn is_whole(&self) -> bool {
        self.cases.is_empty() && self.methods.is_empty() && self.knobs.is_empty()
    }

    /// The cases of the curves.
    ///
    /// # Errors
    /// If one is not there; the message has those that are.
    pub fn cases(&self) -> Result<Vec<&'static dyn Case>, StudyError> {
        let drawn = |case: &&&dyn Case| !NO_CURVES.contains(&case.name());
        if self.cases.is_empty() {
            let wanted = |case: &&&dyn Case| drawn(case) && (!self.quick || QUICK.contains(&case.name()));
            return Ok(CASES.iter().filter(wanted).copied().collect());
        }
        let known = || CASES.iter().filter(drawn).map(|case| case.name()).collect::<Vec<_>>();
        let one = |name: &String| {
            case::case(name).filter(|case| drawn(&case)).ok_or_else(|| unknown("--scenes", name, &known()))
        };
        self.cases.iter().map(one).collect()
    }

    /// The methods of the curves.
    ///
    /// # Errors
    /// As [`Choice::cases`].
    pub fn methods(&self) -> Result<Vec<&'static Method>, StudyError> {
        if self.methods.is_empty() {
            return Ok(METHODS.iter().collect());
        }
        let known: Vec<&str> = METHODS.iter().map(|method| method.name).collect();
        let one = |name: &String| crate::method::method(name).ok_or_else(|| unknown("--methods", name, &known));
        self.methods.iter().map(one).collect()
    }

    fn check_knobs(&self, methods: &[&Method]) -> Result<(), StudyError> {
        let known: Vec<&str> =
            methods.iter().flat_map(|method| knobs(method.name).map(|(_, knob)| knob.name)).collect();
        match self.knobs.iter().find(|name| !known.contains(&name.as_str())) {
            Some(name) => Err(unknown("--knobs", name, &known)),
            None => Ok(()),
        }
    }
}

fn unknown(option: &str, name: &str, known: &[&str]) -> StudyError {
    StudyError::Unknown(format!("{option} {name}: there is none of that name; there are {}", known.join(", ")))
}

/// The tasks of the chosen curves, each once.
///
/// # Errors
/// If a name is not there.
pub fn tasks(choice: &Choice) -> Result<Vec<Task>, StudyError> {
    let mut tasks: Vec<Task> = Vec::new();
    for curve in curves(choice)? {
        for (_, task) in curve.tasks {
            if !tasks.contains(&task) {
                tasks.push(task);
            }
        }
    }
    Ok(tasks)
}

/// The task of one position, or of the case as it is.
pub(crate) fn task(part: &str, case: &dyn Case, settings: Vec<String>, repeats: u32) -> Task {
    Task {
        part: part.into(),
        case: case.name().into(),
        settings,
        tier: tier_name(brooklet_gpu::Tier::Desktop).into(),
        repeats,
    }
}

/// Runs a case with its settings on the GPU, judges the first run, and times all.
///
/// # Errors
/// If the case is not there, or the device.
pub fn run_case(session: &Session<'_>, task: &Task) -> Result<Option<Outcome>, StudyError> {
    let case =
        case::case(&task.case).ok_or_else(|| StudyError::Unknown(format!("there is no case '{}'", task.case)))?;
    let setup = match case.setup(&task.settings) {
        Ok(setup) => setup,
        Err(error) => return Ok(Some(Outcome::empty(State::Refused, error.to_string()))),
    };
    let gpu = session.gpu(&task.tier)?;
    let mut runs: Vec<GpuRun> = Vec::new();
    for _ in 0..task.repeats.max(1) {
        match session.run_setup(&gpu, &setup) {
            Ok(run) if run.stopped => return Ok(None),
            Ok(run) => runs.push(run),
            Err(reason) => return Ok(Some(Outcome::empty(State::Refused, reason))),
        }
    }
    let (state, reason) = state_of(&runs[0]);
    let mut outcome = Outcome::empty(state, reason);
    if matches!(state, State::Stable | State::Clamped) {
        let converge = |setup: &Setup| session.converge(setup);
        let Some(figures) = case.figures(&setup, &runs[0].samples, &converge) else { return Ok(None) };
        outcome.figures = figures;
        outcome.figures.extend(common(&setup, &runs[0], case.energy_rise()));
        outcome.series = case.series(&setup, &runs[0].samples);
    }
    let warm_up = WARM_UP.min(setup.steps() as usize / 4);
    outcome.cost = GpuRun::cost(&runs, warm_up, setup.scene.solver.dt_s);
    outcome.particles = setup.count() as u64;
    outcome.step_ms = thinned(&runs[0].step_ms);
    outcome.device = gpu.info().name.clone();
    Ok(Some(outcome))
}

/// Of every run: its energy, which may rise by so much of that at play; and its density.
pub(crate) fn common(setup: &Setup, run: &GpuRun, energy_rise: f64) -> Vec<Figure> {
    energy::figures(setup, run, energy_rise).into_iter().chain(densities(run)).collect()
}

/// The program's own measurement of its density.
pub(crate) fn densities(run: &GpuRun) -> Vec<Figure> {
    let Some(last) = run.measured.last() else { return Vec::new() };
    let worst = run.measured.iter().map(|m| m.stats.compression.p99).fold(0.0, f64::max);
    let compression = last.stats.compression;
    vec![
        Figure::told("compression", compression.mean, "", "mean of max(density ratio - 1, 0) at the end"),
        Figure::told("compression p99", worst, "", "of 99 of 100 particles, largest of all samples"),
        Figure::told(
            "density error",
            last.stats.density_error.mean,
            "",
            "mean of |density ratio - 1| at the end, surface included",
        ),
    ]
}

/// At most some two hundred, evenly.
fn thinned(step_ms: &[f64]) -> Vec<f64> {
    let every = step_ms.len().div_ceil(200).max(1);
    step_ms.iter().step_by(every).map(|ms| (ms * 1e4).round() / 1e4).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn choice() -> Choice {
        Choice { cases: Vec::new(), methods: Vec::new(), knobs: Vec::new(), quick: false }
    }

    #[test]
    fn unknown_names_are_answered_with_the_known() {
        let error = |choice: Choice| tasks(&choice).unwrap_err().to_string();
        let name = || vec!["nothing".to_string()];
        assert!(error(Choice { cases: name(), ..choice() }).contains("elliptical-drop"));
        assert!(error(Choice { methods: name(), ..choice() }).contains("pbf"));
        assert!(error(Choice { knobs: name(), ..choice() }).contains("iterations"));
    }

    #[test]
    fn a_point_that_curves_share_is_one_task() {
        let all = tasks(&choice()).unwrap();
        let mut keys: Vec<String> = all.iter().map(|task| task.key("")).collect();
        keys.sort_unstable();
        keys.dedup();
        assert_eq!(keys.len(), all.len());
        assert!(tasks(&Choice { quick: true, ..choice() }).unwrap().len() * 4 < all.len());
    }
}
