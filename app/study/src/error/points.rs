//! Curves and their points.

use super::{Choice, PART, task};
use crate::case::{Case, setting};
use crate::knob::{knobs, positions};
use crate::method::Method;
use crate::session::StudyError;
use crate::{State, Store, Task};

/// One knob of one method on one case.
pub struct Curve {
    /// The case.
    pub case: &'static dyn Case,
    /// The solver.
    pub method: &'static Method,
    /// The knob's name.
    pub knob: &'static str,
    /// Its positions, with what is run for each.
    pub tasks: Vec<(String, Task)>,
}

/// A point of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The knob's position.
    pub label: String,
    /// How it ended.
    pub state: State,
    /// The case's error; none of a failure.
    pub error: Option<f64>,
    /// GPU seconds a simulated second: median and 95th percentile; none of what never ran.
    pub time_s_per_s: Option<(f64, f64)>,
}

/// The chosen curves.
///
/// # Errors
/// If a name is not there.
pub fn curves(choice: &Choice) -> Result<Vec<Curve>, StudyError> {
    let (cases, methods) = (choice.cases()?, choice.methods()?);
    choice.check_knobs(&methods)?;
    let mut curves = Vec::new();
    for case in cases {
        for &method in &methods {
            let named = |name: &str| choice.knobs.is_empty() || choice.knobs.iter().any(|knob| knob == name);
            // Of a costly solver that nobody asked for, few.
            let unasked = choice.methods.is_empty();
            let few = choice.quick || unasked && !method.few.is_empty();
            let wanted = |name: &str| named(name) && (!unasked || method.turns(name, choice.quick));
            let repeats = if few { 1 } else { 2 };
            for (field, knob) in knobs(method.name).filter(|(_, knob)| wanted(knob.name)) {
                let tasks = positions(field, &knob, case, few)
                    .into_iter()
                    .map(|position| {
                        let mut settings = vec![method.setting()];
                        // What is as it is anyway is not another task.
                        if !is_default(case, method, &position.settings) {
                            settings.extend(position.settings);
                        }
                        (position.label, task(PART, case, settings, repeats))
                    })
                    .collect();
                curves.push(Curve { case, method, knob: knob.name, tasks });
            }
        }
    }
    Ok(curves)
}

/// Whether settings change nothing of the case's scene by that solver.
fn is_default(case: &dyn Case, method: &Method, settings: &[String]) -> bool {
    // A spacing also changes the case's text.
    if settings.iter().any(|setting| setting.starts_with("spacing_m=")) {
        return setting(settings, "spacing_m", 0.0) == case.spacing_m();
    }
    let by = |settings: &[String]| case.setup(&[&[method.setting()], settings].concat());
    match (by(&[]), by(settings)) {
        (Ok(plain), Ok(changed)) => plain.scene == changed.scene,
        _ => false,
    }
}

impl Curve {
    /// Its points, as far as they have run.
    pub fn points(&self, store: &Store) -> Vec<Point> {
        let point = |(label, task): &(String, Task)| {
            let outcome = store.get(task)?;
            Some(Point {
                label: label.clone(),
                state: outcome.state,
                error: outcome.error().map(f64::abs),
                time_s_per_s: outcome.cost.map(|cost| (cost.median_s_per_s, cost.p95_s_per_s)),
            })
        };
        self.tasks.iter().filter_map(point).collect()
    }
}

/// Which of some (error, time) are on the Pareto front: none is better in both.
pub fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let beats = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1);
    points.iter().map(|point| !points.iter().any(|other| beats(other, point))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_nothing_beats() {
        let points = [(1.0, 5.0), (2.0, 3.0), (2.5, 3.0), (3.0, 1.0), (3.0, 4.0), (0.5, 9.0)];
        assert_eq!(front(&points), [true, true, false, true, false, true]);
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0)]), [true, true], "equals do not beat each other");
        assert!(front(&[]).is_empty());
    }
}
