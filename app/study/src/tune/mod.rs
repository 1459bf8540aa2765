//! The cheapest setting of a scene for an error, or the most exact one for a time, by a bounded search; the solver too.
//!
//! What is searched of PBF: substeps and iterations with `solver.pbf.acceleration = "chebyshev"` and a coarse correction, then
//! without the latter, without both, with a warm start, and `solver.precision = "relaxed"`. The first guess comes from what the study found: a substep costs what an iteration
//! does and about two more, and the column law makes the error fall with what the iterations do to slow modes and with
//! the square of the substeps. Every candidate that counts is then
//! run; what is chosen was measured, and is run once more. Other solvers are run where a table of error against time
//! ([`solvers`]) says that they may come near.

pub mod solvers;

use brooklet_fluid::particles::sample_lattice;
use brooklet_fluid::scene::{Acceleration, Method, Precision};
use brooklet_fluid::solver::pbf::{Chebyshev, IterationWeights, MOST_WARM_START};
use brooklet_fluid::{Scene, SessionError};
use brooklet_gpu::Gpu;
use thiserror::Error;

use self::solvers::{RUNGS, Rung, solvers_of, times_of_pbf};
use crate::Setup;
use crate::backend::{GpuRun, Options, run};

/// What is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// The smallest error whose step takes no longer, ms of GPU time.
    BudgetMs(f64),
    /// The shortest step whose error is no larger: compression that 99 of 100 particles do not exceed,
    /// mean over the run.
    MaxError(f64),
}

/// A solver with a setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Candidate {
    /// PBF.
    Pbf(Iterated),
    /// Another.
    Other(&'static Rung),
}

/// A setting of PBF.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Iterated {
    /// Equal parts of a step.
    pub substeps: u32,
    /// Iterations of each.
    pub iterations: u32,
    /// Whether iterations are accelerated, whatever the scene says.
    pub accelerated: bool,
    /// Whether the first iteration has a coarse correction where it can.
    pub coarse: bool,
    /// Whether substeps begin with as much of the last one's pressure as they may.
    pub warm: bool,
    /// Whether the precision is `relaxed`, whatever the scene says.
    pub relaxed: bool,
}

/// A setting that was run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// The setting.
    pub candidate: Candidate,
    /// Median GPU time of a step, ms.
    pub step_ms: f64,
    /// Compression that 99 of 100 particles do not exceed, mean over the run.
    pub error: f64,
}

/// What a search found.
#[derive(Clone, Debug)]
pub struct Found {
    /// What is chosen: as it was measured in the search.
    pub chosen: Tried,
    /// Everything that was run, in order.
    pub tried: Vec<Tried>,
    /// The chosen setting, run again.
    pub checked: Tried,
    /// Whether the goal is met by what was measured; if not, the nearest to it is chosen.
    pub meets: bool,
    /// Solvers that were not run, and how many times as long as PBF they take by the table.
    pub passed_over: Vec<(&'static str, f64)>,
}

/// Why a search ends without a result.
#[derive(Debug, Error)]
pub enum TuneError {
    /// A run failed.
    #[error(transparent)]
    Run(#[from] SessionError),
    /// It was stopped.
    #[error("stopped")]
    Stopped,
    /// Nothing can be told of the scene.
    #[error("{0}")]
    Nothing(String),
}

/// A search tries no more than so many settings of PBF,
pub const MOST_TRIED: usize = 16;
/// and so many of all solvers.
pub const MOST_TRIED_IN_ALL: usize = MOST_TRIED + RUNGS.len();
/// A solver that takes more times as long as PBF by the table, for the error that PBF came to, is not run.
const WORTH: f64 = 3.0;
const SUBSTEPS: [u32; 7] = [1, 2, 3, 4, 6, 8, 12];
/// Fewer have no momentum in two dimensions, which a warm start needs.
const LEAST_WARM_ITERATIONS: u32 = 3;
const ITERATIONS: [u32; 8] = [1, 2, 3, 4, 6, 8, 12, 16];
/// A substep's sort and list, in iterations: about what every device showed.
const SUBSTEP_ITERATIONS: f64 = 2.0;
/// Of plain iterations, and of the kernel at the default support: what the guess is made of.
const RELAXATION: f64 = 0.5;
const LAMBDA_MAX: f64 = 2.6;
/// Moments at which the error is measured.
const MOMENTS: u32 = 10;

impl Candidate {
    /// The solver.
    pub fn method(self) -> &'static str {
        match self {
            Self::Pbf(_) => "pbf",
            Self::Other(rung) => rung.method,
        }
    }

    /// The scene with it.
    ///
    /// # Errors
    /// If the scene does not allow it.
    pub fn apply(self, scene: &Scene) -> Result<Scene, TuneError> {
        match self {
            Self::Pbf(iterated) => {
                let pbf = match scene.solver.method {
                    Method::Pbf => Ok(scene.clone()),
                    _ => Scene::from_toml(&scene.to_toml(), &scene.name, &["solver.method=pbf".into()]),
                };
                pbf.map(|pbf| iterated.apply(&pbf)).map_err(|error| TuneError::Nothing(error.to_string()))
            }
            Self::Other(rung) => rung.apply(scene).map_err(|error| TuneError::Nothing(error.to_string())),
        }
    }
}

impl Iterated {
    /// In iterations of one substep.
    fn cost(self) -> f64 {
        f64::from(self.substeps) * (f64::from(self.iterations) + SUBSTEP_ITERATIONS)
    }

    /// Up to a factor that the scene has.
    fn law(self) -> f64 {
        let plain = RELAXATION * f64::from(self.iterations);
        let response = match self.accelerated {
            true => Chebyshev::new(self.iterations, LAMBDA_MAX).response.max(plain),
            false => plain,
        };
        1.0 / (response * f64::from(self.substeps).powi(2))
    }

    /// The scene with this setting.
    pub fn apply(self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.solver.substeps = self.substeps;
        scene.solver.pbf.iterations = self.iterations;
        scene.solver.pbf.acceleration = if self.accelerated { Acceleration::Chebyshev } else { Acceleration::None };
        // Left out it is there where it can be: a single iteration has nothing to take back what is too much.
        scene.solver.pbf.coarse_correction = if self.coarse { None } else { Some(false) };
        if self.accelerated && scene.solver.pbf.relaxation.is_some_and(|own| own >= scene.relaxation_limit()) {
            // A weight that an acceleration refuses.
            scene.solver.pbf.relaxation = None;
        }
        // Iterations without momentum refuse it.
        let may_be_warm = IterationWeights::of(&scene).chebyshev.is_some();
        scene.solver.pbf.warm_start = if self.warm && may_be_warm { MOST_WARM_START } else { 0.0 };
        if self.relaxed {
            scene.solver.precision = Precision::Relaxed;
        }
        scene
    }
}

/// Candidates that nothing beats by cost and law, cheapest first.
fn ladder() -> Vec<Iterated> {
    let one = Iterated { substeps: 1, iterations: 1, accelerated: true, coarse: true, warm: false, relaxed: false };
    let of = |substeps| ITERATIONS.map(|iterations| Iterated { substeps, iterations, ..one });
    let mut all: Vec<Iterated> = SUBSTEPS.iter().flat_map(|&substeps| of(substeps)).collect();
    all.sort_by(|a, b| a.cost().total_cmp(&b.cost()).then(a.law().total_cmp(&b.law())));
    let mut best: Vec<Iterated> = Vec::new();
    for candidate in all {
        if best.last().is_none_or(|last| candidate.law() < last.law()) {
            best.push(candidate);
        }
    }
    best
}

/// Searches among `methods` (by name; empty: all that may move the scene); `seconds` of each run are simulated. `told` hears
/// of each setting that was run.
///
/// # Errors
/// If a run fails or `stop` says so.
pub fn tune(
    gpu: &Gpu,
    scene: &Scene,
    goal: Goal,
    methods: &[String],
    seconds: f64,
    stop: &dyn Fn() -> bool,
    told: &mut dyn FnMut(&Tried),
) -> Result<Found, TuneError> {
    let mut measure = |candidate: Candidate| try_one(gpu, scene, candidate, seconds, stop);
    let may = solvers_of(scene);
    if let Some(other) = methods.iter().find(|name| !may.contains(&name.as_str())) {
        let reason = format!("--methods {other}: what moves {} may be {}", scene.name, may.join(", "));
        return Err(TuneError::Nothing(reason));
    }
    let wanted = |name: &&'static str| methods.is_empty() || methods.iter().any(|method| method == name);
    let solvers: Vec<&'static str> = may.into_iter().filter(wanted).collect();
    search(goal, &solvers, &mut measure, told)
}

/// The search itself, over whatever runs a candidate.
fn search(
    goal: Goal,
    solvers: &[&'static str],
    measure: &mut dyn FnMut(Candidate) -> Result<Tried, TuneError>,
    told: &mut dyn FnMut(&Tried),
) -> Result<Found, TuneError> {
    let fits = |found: &Tried| goal.is_met_by(found);
    let mut tried: Vec<Tried> = Vec::new();
    if solvers.contains(&"pbf") {
        search_pbf(goal, measure, told, &mut tried)?;
    }
    let pbf = choose(goal, &tried);
    let mut passed_over = Vec::new();
    for &method in solvers.iter().filter(|method| **method != "pbf") {
        // Whoever is asked for alone, or is needed, is run whatever the table says.
        let times = pbf.filter(fits).and_then(|pbf| times_of_pbf(method, pbf.error));
        match times {
            Some(times) if times > WORTH => passed_over.push((method, times)),
            _ => climb(goal, method, measure, told, &mut tried)?,
        }
    }
    let chosen = choose(goal, &tried).ok_or_else(|| TuneError::Nothing("nothing could be measured".into()))?;
    let checked = measure(chosen.candidate)?;
    Ok(Found { chosen, meets: fits(&chosen), tried, checked, passed_over })
}

impl Goal {
    fn is_met_by(self, found: &Tried) -> bool {
        match self {
            Goal::BudgetMs(ms) => found.step_ms <= ms,
            Goal::MaxError(error) => found.error <= error,
        }
    }
}

/// A solver's rungs from the cheapest on, as far as they are of use.
fn climb(
    goal: Goal,
    method: &str,
    measure: &mut dyn FnMut(Candidate) -> Result<Tried, TuneError>,
    told: &mut dyn FnMut(&Tried),
    tried: &mut Vec<Tried>,
) -> Result<(), TuneError> {
    for rung in RUNGS.iter().filter(|rung| rung.method == method) {
        // A rung that the scene refuses is none; the next ones ask for more still.
        let found = match measure(Candidate::Other(rung)) {
            Ok(found) => found,
            Err(TuneError::Nothing(_)) if !tried.is_empty() => break,
            Err(error) => return Err(error),
        };
        told(&found);
        tried.push(found);
        // The first that is exact enough, or the first that takes too long, is the last.
        if matches!(goal, Goal::MaxError(_)) == goal.is_met_by(&found) {
            break;
        }
    }
    Ok(())
}

/// PBF's.
fn search_pbf(
    goal: Goal,
    measure: &mut dyn FnMut(Candidate) -> Result<Tried, TuneError>,
    told: &mut dyn FnMut(&Tried),
    tried: &mut Vec<Tried>,
) -> Result<(), TuneError> {
    let ladder = ladder();
    let mut look = |at: Iterated, tried: &mut Vec<Tried>| -> Result<Tried, TuneError> {
        let at = Candidate::Pbf(at);
        if let Some(known) = tried.iter().find(|known| known.candidate == at) {
            return Ok(*known);
        }
        let found = measure(at)?;
        told(&found);
        tried.push(found);
        Ok(found)
    };
    // A rung is fit if it keeps to the goal's side: within the budget, or within the error. Fit rungs are
    // the low ones of a budget and the high ones of an error.
    let (mut low, mut high) = (0, ladder.len() - 1);
    let rising = matches!(goal, Goal::MaxError(_));
    // The edge between fit and unfit, by halves.
    while low < high && tried.len() + 6 < MOST_TRIED {
        let middle = (low + high) / 2 + usize::from(!rising);
        let fit = goal.is_met_by(&look(ladder[middle], tried)?);
        match (rising, fit) {
            (true, true) => high = middle,
            (true, false) => low = middle + 1,
            (false, true) => low = middle,
            (false, false) => high = middle - 1,
        }
    }
    // The ladder's order is a guess: its neighbours by measure, and those with less in them, may be better.
    for at in [low.checked_sub(1), Some(low), Some(low + 1)].into_iter().flatten() {
        if let Some(&candidate) = ladder.get(at)
            && tried.len() < MOST_TRIED
        {
            look(candidate, tried)?;
        }
    }
    let found = ladder[low];
    let fine = Iterated { coarse: false, ..found };
    let warm = Iterated { warm: true, ..found };
    for other in [Iterated { relaxed: true, ..found }, warm, fine, Iterated { accelerated: false, ..fine }] {
        if tried.len() < MOST_TRIED && (!other.warm || other.iterations >= LEAST_WARM_ITERATIONS) {
            look(other, tried)?;
        }
    }
    Ok(())
}

/// The best of those that meet the goal; where none does, the nearest to it.
fn choose(goal: Goal, tried: &[Tried]) -> Option<Tried> {
    let best = |wanted: &dyn Fn(&Tried) -> bool, of: &dyn Fn(&Tried) -> f64| {
        tried.iter().filter(|t| wanted(t)).min_by(|a, b| of(a).total_cmp(&of(b))).copied()
    };
    match goal {
        Goal::BudgetMs(ms) => best(&|t| t.step_ms <= ms, &|t| t.error).or_else(|| best(&|_| true, &|t| t.step_ms)),
        Goal::MaxError(error) => best(&|t| t.error <= error, &|t| t.step_ms).or_else(|| best(&|_| true, &|t| t.error)),
    }
}

fn try_one(
    gpu: &Gpu,
    scene: &Scene,
    candidate: Candidate,
    seconds: f64,
    stop: &dyn Fn() -> bool,
) -> Result<Tried, TuneError> {
    let scene = candidate.apply(scene)?;
    let particles = sample_lattice(&scene);
    if particles.positions.is_empty() {
        return Err(TuneError::Nothing(format!("{}: the scene has no particles to tune for", scene.name)));
    }
    let dt_s = scene.solver.dt_s;
    let sample_times_s = (1..=MOMENTS).map(|k| seconds * f64::from(k) / f64::from(MOMENTS)).collect();
    let relaxes = scene.solver.method.relaxes();
    let setup = Setup { scene, particles, sample_times_s, relaxes, squeezed: false };
    let options = Options { stop, ..Options::default() };
    let run = run(gpu, &setup, &options)?;
    if run.stopped {
        return Err(TuneError::Stopped);
    }
    let errors: Vec<f64> = run.measured.iter().map(|measured| measured.stats.compression.p99).collect();
    let error = errors.iter().sum::<f64>() / errors.len().max(1) as f64;
    let warm_up = 10.min(run.step_ms.len() / 4);
    let cost = GpuRun::cost(&[run], warm_up, dt_s).ok_or_else(|| TuneError::Nothing("no step was timed".into()))?;
    Ok(Tried { candidate, step_ms: cost.median_s_per_s * dt_s * 1e3, error })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A device and a fluid that do what the guess says, or not quite.
    fn made_up(candidate: Candidate, skew: f64) -> Tried {
        let whole = candidate;
        let candidate = match candidate {
            Candidate::Pbf(iterated) => iterated,
            Candidate::Other(rung) => {
                let nth = RUNGS.iter().position(|other| other == rung).unwrap() as i32;
                return Tried { candidate, step_ms: 4.0 * 2.0_f64.powi(nth), error: 0.04 * 4.0_f64.powi(-nth) };
            }
        };
        let packing = if candidate.relaxed { 0.95 } else { 1.0 } * if candidate.warm { 1.03 } else { 1.0 };
        let gain = if candidate.accelerated { 1.0 } else { 0.5 } * if candidate.coarse { 1.0 } else { 0.7 };
        let iterations = gain * f64::from(candidate.iterations).powf(1.0 + skew);
        let step_ms = f64::from(candidate.substeps) * (f64::from(candidate.iterations) + 2.0 + 3.0 * skew) * packing;
        let error = 0.3 / (iterations * f64::from(candidate.substeps).powf(2.0 - skew)) * (2.0 - packing);
        Tried { candidate: whole, step_ms, error }
    }

    fn find(goal: Goal, skew: f64) -> Found {
        let mut count = 0;
        let mut measure = |candidate| {
            count += 1;
            Ok(made_up(candidate, skew))
        };
        let found = search(goal, &["pbf"], &mut measure, &mut |_| {}).unwrap();
        assert!(found.tried.len() <= MOST_TRIED && count <= MOST_TRIED + 1);
        found
    }

    #[test]
    fn the_ladder_rises_in_cost_and_falls_in_error() {
        let ladder = ladder();
        assert!(ladder.len() > 10);
        assert!(ladder.windows(2).all(|pair| pair[0].cost() < pair[1].cost() && pair[0].law() > pair[1].law()));
    }

    #[test]
    fn a_budget_is_kept_and_used() {
        for (budget, skew) in [(6.0, 0.0), (20.0, 0.0), (20.0, 0.3), (60.0, -0.2)] {
            let found = find(Goal::BudgetMs(budget), skew);
            assert!(found.meets && found.chosen.step_ms <= budget, "{found:?}");
            let better = found.tried.iter().any(|t| t.step_ms <= budget && t.error < found.chosen.error);
            assert!(!better, "{found:?}");
            assert!(found.chosen.step_ms > 0.4 * budget, "{budget}: {:?}", found.chosen);
        }
    }

    #[test]
    fn an_error_is_kept_and_what_is_cheaper_breaks_it() {
        for (error, skew) in [(0.1, 0.0), (0.01, 0.0), (0.01, 0.3), (0.003, -0.2)] {
            let found = find(Goal::MaxError(error), skew);
            assert!(found.meets && found.chosen.error <= error, "{found:?}");
            let cheaper: Vec<&Tried> = found.tried.iter().filter(|t| t.step_ms < found.chosen.step_ms).collect();
            assert!(!cheaper.is_empty() && cheaper.iter().all(|t| t.error > error), "{found:?}");
        }
    }

    #[test]
    fn a_candidate_is_a_scene_that_is_allowed() {
        let settings = ["solver.pbf.acceleration=none".into(), "solver.pbf.relaxation=0.9".into()];
        let scene = Scene::load("calm-pool", &settings).unwrap();
        for candidate in ladder() {
            let tuned = candidate.apply(&scene);
            assert_eq!(Scene::from_toml(&tuned.to_toml(), "tuned", &[]).unwrap().solver, tuned.solver);
            let warm = Iterated { warm: true, ..candidate }.apply(&scene);
            assert_eq!(Scene::from_toml(&warm.to_toml(), "tuned", &[]).unwrap().solver, warm.solver);
            assert_eq!(warm.solver.pbf.warm_start > 0.0, candidate.iterations > 1);
            let plain = Iterated { accelerated: false, coarse: false, warm: true, ..candidate }.apply(&scene);
            assert_eq!(plain.solver.pbf.warm_start, 0.0);
            assert_eq!(plain.solver.pbf.relaxation, Some(0.9));
        }
    }

    #[test]
    fn the_solver_is_chosen_too() {
        let find = |goal: Goal, solvers: &[&'static str], worse: f64| {
            let mut measure = |candidate: Candidate| {
                let tried = made_up(candidate, 0.0);
                let is_pbf = candidate.method() == "pbf";
                Ok(if is_pbf { Tried { error: worse * tried.error, ..tried } } else { tried })
            };
            search(goal, solvers, &mut measure, &mut |_| {}).unwrap()
        };
        // By the table the other is not worth a run where PBF does it; it is run where PBF does not, or alone.
        let found = find(Goal::MaxError(0.01), &["pbf", "sph"], 1.0);
        assert!(found.meets && found.chosen.candidate.method() == "pbf", "{found:?}");
        assert!(found.passed_over[0].0 == "sph" && found.passed_over[0].1 > WORTH);
        let found = find(Goal::MaxError(0.01), &["pbf", "sph"], 1e3);
        assert_eq!((found.chosen.candidate.method(), found.meets, found.passed_over.len()), ("sph", true, 0));
        assert_eq!(found.chosen.step_ms, 8.0, "the cheapest rung that is exact enough");
        for (goal, error) in [(Goal::MaxError(0.002), 0.000625), (Goal::BudgetMs(20.0), 0.0025)] {
            let found = find(goal, &["sph"], 1.0);
            assert!(found.meets && (found.chosen.error - error).abs() < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn what_cannot_be_met_is_not_claimed() {
        assert!(!find(Goal::BudgetMs(0.5), 0.0).meets);
        assert!(!find(Goal::MaxError(1e-9), 0.0).meets);
    }
}
