//! Whether the f64 twins converge to the closed forms: the order over spacings.

use super::{ORDER_PART, task};
use crate::case::{Case, EllipticalDrop, STANDING_WAVE};
use crate::method::{METHODS, Method};
use crate::session::{Session, StudyError};
use crate::{Figure, Outcome, Sample, State, Task, case, energy};

/// Cases whose order is shown, which figure falls, and the spacings (multiples of the case's own, falling).
pub const ORDER_CASES: &[(&dyn Case, &str, &[f64])] =
    &[(&EllipticalDrop, "axis error", &[2.0, 1.0, 0.5]), (&STANDING_WAVE, "amplitude error", &[2.0, 1.0, 0.5])];
/// What leaves little of the error that a solver's work leaves, so that the order is the discretisation's: many iterations, or
/// small tolerances. An equation of state's compression is part of what it is.
const EXACT: [(&str, &[&str]); 2] = [
    ("pbf", &["solver.pbf.iterations=24"]),
    ("dfsph", &["solver.dfsph.divergence_tolerance=3e-5", "solver.dfsph.density_tolerance=1e-4"]),
];

/// A run of each solver, case and spacing, with whose it is; a quick look takes the coarser two of the first solver and case.
pub fn order_tasks(quick: bool) -> Vec<(&'static Method, Task)> {
    let methods = METHODS.iter().take(if quick { 1 } else { METHODS.len() });
    let cases = ORDER_CASES.iter().take(if quick { 1 } else { ORDER_CASES.len() });
    let mut tasks = Vec::new();
    for method in methods {
        let exact = EXACT.iter().filter(|(name, _)| *name == method.name).flat_map(|(_, settings)| *settings);
        for &(case, _, factors) in cases.clone() {
            for factor in if quick { &factors[..2] } else { factors } {
                let spacing = format!("spacing_m={:?}", factor * case.spacing_m());
                let mut settings = vec![method.setting(), spacing];
                settings.extend(exact.clone().map(|&setting| setting.to_owned()));
                tasks.push((method, task(ORDER_PART, case, settings, 1)));
            }
        }
    }
    tasks
}

/// Runs a case in f64.
///
/// # Errors
/// If the case is not there.
pub fn run_order(session: &Session<'_>, task: &Task) -> Result<Option<Outcome>, StudyError> {
    let case =
        case::case(&task.case).ok_or_else(|| StudyError::Unknown(format!("there is no case '{}'", task.case)))?;
    let setup = match case.setup(&task.settings) {
        Ok(setup) => setup,
        Err(error) => return Ok(Some(Outcome::empty(State::Refused, error.to_string()))),
    };
    let Some(samples) = session.converge(&setup) else { return Ok(None) };
    let none = |_: &crate::Setup| None;
    let Some(mut figures) = case.figures(&setup, &samples, &none) else { return Ok(None) };
    let moments: Vec<&Sample> = samples.iter().collect();
    figures.extend(energy::of_samples(&setup, &moments, case.energy_rise()));
    figures.push(Figure::told("spacing", setup.scene.spacing_m, "m", "of the lattice at the start"));
    let mut outcome = Outcome::empty(State::Stable, "");
    outcome.figures = figures;
    outcome.particles = setup.count() as u64;
    outcome.device = "the processor, in f64".into();
    Ok(Some(outcome))
}
