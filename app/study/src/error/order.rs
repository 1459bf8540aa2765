//! Whether the f64 twins converge to the closed forms: the order over spacings.

use super::{ORDER_PART, task};
use crate::case::{Case, EllipticalDrop, StandingWave};
use crate::session::{Session, StudyError};
use crate::{Figure, Outcome, Sample, State, Task, case, energy};

/// Cases whose order is shown, which figure falls, and the spacings (multiples of the case's own, falling).
pub const ORDER_CASES: &[(&dyn Case, &str, &[f64])] =
    &[(&EllipticalDrop, "axis error", &[2.0, 1.0, 0.5]), (&StandingWave, "amplitude error", &[2.0, 1.0, 0.5])];
/// So many iterations leave little of the compression that PBF's few would: the order is the
/// discretisation's.
const ITERATIONS: u32 = 24;

/// A run of each case and spacing; a quick look takes the coarser two of the first.
pub fn order_tasks(quick: bool) -> Vec<Task> {
    let of = |&(case, _, factors): &(&'static dyn Case, &'static str, &'static [f64])| {
        let taken = if quick { &factors[..2] } else { factors };
        let settings = |factor: &f64| {
            vec![format!("spacing_m={:?}", factor * case.spacing_m()), format!("solver.pbf.iterations={ITERATIONS}")]
        };
        taken.iter().map(|factor| task(ORDER_PART, case, settings(factor), 1)).collect::<Vec<_>>()
    };
    ORDER_CASES.iter().take(if quick { 1 } else { ORDER_CASES.len() }).flat_map(of).collect()
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
