//! Work-precision: a plot a case, a curve a knob.

use maud::{Markup, PreEscaped, html};

use plotters::style::RGBColor;

use super::plot::{INK, Line, Mark, PALETTE, Plot, RED};
use crate::case::Reference;
use crate::error::{Choice, Curve, Point, curves, front};
use crate::method::{METHODS, Method};
use crate::session::StudyError;
use crate::{State, Store};

/// Width, least height, and what a line of the legend takes.
const SIZE_PX: [u32; 3] = [860, 430, 22];
/// A solver's, in the order of [`METHODS`].
const MARKS: [Mark; 3] = [Mark::LineDots, Mark::LineSquares, Mark::LineTriangles];

/// A solver's mark, the same in all plots.
pub fn mark_of(method: &Method) -> Mark {
    let solver = METHODS.iter().position(|of| of.name == method.name).unwrap_or(0);
    MARKS[solver % MARKS.len()]
}

/// How a curve is drawn: a knob's colour is the same by every solver, a solver's mark by every knob.
fn look(curve: &Curve, curves: &[Curve]) -> (Mark, RGBColor) {
    let mut knobs: Vec<&str> = Vec::new();
    for curve in curves {
        if !knobs.contains(&curve.knob) {
            knobs.push(curve.knob);
        }
    }
    let place = knobs.iter().position(|knob| *knob == curve.knob).unwrap_or(0);
    (mark_of(curve.method), PALETTE[place % PALETTE.len()])
}

/// Curves by case, in order.
fn by_case(choice: &Choice) -> Result<Vec<Vec<Curve>>, StudyError> {
    let mut cases: Vec<Vec<Curve>> = Vec::new();
    for curve in curves(choice)? {
        match cases.last_mut().filter(|of| of[0].case.name() == curve.case.name()) {
            Some(of) => of.push(curve),
            None => cases.push(vec![curve]),
        }
    }
    Ok(cases)
}

/// Error and median time of a point that has both.
fn place(point: &Point) -> Option<(f64, f64)> {
    let sound = matches!(point.state, State::Stable | State::Clamped);
    let (error, (median, _)) = (point.error?, point.time_s_per_s?);
    (sound && error > 0.0).then_some((error, median))
}

/// A plot a case.
pub fn plots(choice: &Choice, store: &Store) -> Result<Vec<(String, String)>, StudyError> {
    let named = |of: Vec<Curve>| (format!("work-precision-{}", of[0].case.name()), plot(&of, store).svg());
    Ok(by_case(choice)?.into_iter().map(named).collect())
}

fn plot(curves: &[Curve], store: &Store) -> Plot {
    let case = curves[0].case;
    let mut lines = Vec::new();
    let mut all: Vec<(f64, f64)> = Vec::new();
    let mut failed: Vec<f64> = Vec::new();
    let solvers = solvers(curves);
    for curve in curves {
        let (mark, color) = look(curve, curves);
        let points = curve.points(store);
        let places: Vec<(f64, f64)> = points.iter().filter_map(place).collect();
        let lost = points.iter().filter(|point| !matches!(point.state, State::Stable | State::Clamped));
        failed.extend(lost.filter_map(|point| point.time_s_per_s.map(|(median, _)| median)));
        all.extend(&places);
        let name = if solvers.len() > 1 { format!("{} {}", curve.method.name, curve.knob) } else { curve.knob.into() };
        lines.push(Line { name, color, mark, points: places });
    }
    let on_front = front(&all);
    let mut best: Vec<(f64, f64)> = all.iter().zip(on_front).filter(|(_, on)| *on).map(|(point, _)| *point).collect();
    best.dedup();
    lines.push(Line { name: "Pareto front".into(), color: INK, mark: Mark::Rings, points: best });
    if !failed.is_empty() {
        // Beyond the largest error there is: their own is unknown.
        let edge = 1.5 * all.iter().map(|(error, _)| *error).fold(1e-12, f64::max);
        let points = failed.into_iter().map(|time| (edge, time)).collect();
        lines.push(Line { name: "failed".into(), color: RED, mark: Mark::Crosses, points });
    }
    Plot {
        title: format!("{}: {}", case.name(), solvers.join(", ")),
        x: error_name(curves, store),
        y: "GPU s a simulated s".into(),
        log_x: true,
        log_y: true,
        size_px: (SIZE_PX[0], SIZE_PX[1].max(60 + SIZE_PX[2] * lines.len() as u32)),
        lines,
    }
}

/// Whose curves they are.
fn solvers(curves: &[Curve]) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = curves.iter().map(|curve| curve.method.name).collect();
    names.dedup();
    names
}

/// What the case's error is called.
fn error_name(curves: &[Curve], store: &Store) -> String {
    let outcomes = curves.iter().flat_map(|curve| &curve.tasks).filter_map(|(_, task)| store.get(task));
    let first = outcomes.filter_map(|outcome| outcome.figures.first()).next();
    first.map_or("error".into(), |figure| {
        if figure.unit.is_empty() { figure.name.clone() } else { format!("{}, {}", figure.name, figure.unit) }
    })
}

/// A point that nothing beats: what an error costs at least, and who gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// The case's error.
    pub error: f64,
    /// GPU seconds a simulated second.
    pub s_per_s: f64,
    /// The solver.
    pub method: &'static str,
    /// The knob, and its position.
    pub setting: String,
}

/// Of a case's curves what nothing beats, cheapest first.
fn best(curves: &[Curve], store: &Store) -> Vec<Best> {
    let mut all: Vec<Best> = Vec::new();
    for curve in curves {
        all.extend(curve.points(store).iter().filter_map(|point| {
            let (error, s_per_s) = place(point)?;
            let setting = format!("{} {}", curve.knob, point.label);
            Some(Best { error, s_per_s, method: curve.method.name, setting })
        }));
    }
    let places: Vec<(f64, f64)> = all.iter().map(|best| (best.error, best.s_per_s)).collect();
    let mut kept = front(&places).into_iter();
    all.retain(|_| kept.next().unwrap_or(false));
    all.sort_by(|a, b| a.s_per_s.total_cmp(&b.s_per_s));
    // What several knobs share is one point.
    all.dedup_by(|b, a| (a.error, a.s_per_s) == (b.error, b.s_per_s));
    all
}

/// Which solver for which error and budget, of every case: a table in Markdown, empty where nothing has run.
pub fn solvers_markdown(choice: &Choice, store: &Store) -> Result<String, StudyError> {
    let mut text = String::new();
    for of in by_case(choice)? {
        for best in best(&of, store) {
            let (error, time) = (short(best.error), short(best.s_per_s));
            text += &format!("| {} | {error} | {time} | {} | {} |\n", of[0].case.name(), best.method, best.setting);
        }
    }
    let head = "| case | error | GPU s a simulated s | solver | setting |\n|---|---|---|---|---|\n";
    Ok(if text.is_empty() { text } else { format!("{head}{text}") })
}

/// The section.
pub fn section(choice: &Choice, store: &Store) -> Result<Markup, StudyError> {
    let cases = by_case(choice)?;
    Ok(html! {
        h2 id="error" { "Error against run time" }
        p { "Each curve turns one knob of one solver and leaves the rest of the case as it is: a knob has a colour, a solver a mark. Left and low is better; rings are the Pareto front over all knobs of a plot. Times are GPU timestamps of steps after the first ten, evaluation of errors outside. Kinds of reference are never merged." }
        @for kind in Reference::ALL {
            @let of_kind: Vec<&Vec<Curve>> = cases.iter().filter(|of| of[0].case.reference() == kind).collect();
            @if !of_kind.is_empty() {
                h3 { (capital(kind.title())) }
                @for of in of_kind { (one(of, store)) }
            }
        }
    })
}

fn one(curves: &[Curve], store: &Store) -> Markup {
    let case = curves[0].case;
    html! {
        div.case {
            h4 { (case.name()) }
            p.what { (case.summary()) }
            (PreEscaped(plot(curves, store).svg()))
            @let best = best(curves, store);
            @if !best.is_empty() {
                table {
                    thead { tr { th { "for an error of" } th { "GPU s/s at least" } th { "solver" } th { "setting" } } }
                    tbody {
                        @for best in &best {
                            tr { td.number { (short(best.error)) } td.number { (short(best.s_per_s)) } td { (best.method) } td { (best.setting) } }
                        }
                    }
                }
            }
            details {
                summary { "every point" }
                table {
                    thead { tr { th { "solver" } th { "knob" } th { "position" } th { "outcome" } th { "error" } th { "median GPU s/s" } th { "p95" } } }
                    tbody {
                        @for curve in curves {
                            @for point in curve.points(store) {
                                tr class=(class_of(point.state)) {
                                    td { (curve.method.name) }
                                    td { (curve.knob) }
                                    td { (point.label) }
                                    td { (point.state.word()) }
                                    td.number { (point.error.map_or("–".into(), short)) }
                                    td.number { (point.time_s_per_s.map_or("–".into(), |(median, _)| short(median))) }
                                    td.number { (point.time_s_per_s.map_or("–".into(), |(_, p95)| short(p95))) }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// The class of a row.
pub fn class_of(state: State) -> &'static str {
    match state {
        State::Stable | State::Clamped => "",
        State::Refused | State::NotRun => "grey",
        State::Unstable | State::Silent => "red",
    }
}

/// A number in four digits or so.
pub fn short(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if (0.01..1e4).contains(&size) => format!("{value:.4}"),
        _ => format!("{value:.2e}"),
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Figure, Outcome};

    fn choice() -> Choice {
        let one = |name: &str| vec![name.to_owned()];
        Choice { cases: one("elliptical-drop"), methods: Vec::new(), knobs: one("spacing"), quick: true }
    }

    /// Outcomes of all points: each solver's error and time, halved and quadrupled with each finer spacing.
    fn store(of: &[(&str, f64, f64)]) -> (tempfile::TempDir, Store) {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Store::open(folder.path(), "test").unwrap();
        for curve in curves(&choice()).unwrap() {
            let Some((_, error, s_per_s)) = of.iter().find(|(name, ..)| *name == curve.method.name) else { continue };
            for (nth, (_, task)) in curve.tasks.iter().enumerate() {
                let mut outcome = Outcome::empty(State::Stable, "");
                outcome.figures = vec![Figure::told("error", error * 0.5_f64.powi(nth as i32), "", "")];
                let median_s_per_s = s_per_s * 4.0_f64.powi(nth as i32);
                outcome.cost = Some(crate::Cost { median_s_per_s, p95_s_per_s: median_s_per_s, ..Default::default() });
                store.put(task, outcome).unwrap();
            }
        }
        (folder, store)
    }

    #[test]
    fn every_solver_is_in_one_legend_and_the_best_of_all_are_told() {
        // A quick look turns one knob of a costly solver that nobody named.
        let names = |methods: &[&str]| {
            let methods = methods.iter().map(|&name| name.into()).collect();
            solvers(&curves(&Choice { methods, ..choice() }).unwrap()).join(" ")
        };
        assert_eq!((names(&[]).as_str(), names(&["pbf", "sph"]).as_str()), ("pbf", "pbf sph"));
        let all = curves(&Choice { quick: false, ..choice() }).unwrap();
        assert_eq!(solvers(&all), ["pbf", "sph", "dfsph"]);
        assert_eq!(look(&all[0], &all).1, look(&all[1], &all).1, "one knob, one colour");
        assert_ne!(look(&all[0], &all).0, look(&all[1], &all).0, "two solvers, two marks");
        let (_folder, empty) = store(&[]);
        assert_eq!(solvers_markdown(&choice(), &empty).unwrap(), "");
        let (_folder, store) = store(&[("pbf", 0.1, 1.0)]);
        let table = solvers_markdown(&choice(), &store).unwrap();
        assert_eq!(table.lines().count(), 4, "{table}");
        assert!(table.contains("| elliptical-drop | 0.1000 | 1.0000 | pbf | spacing 125.000 mm |"), "{table}");
    }
}
