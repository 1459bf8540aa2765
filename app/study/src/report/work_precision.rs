//! Work-precision: a plot a case, a curve a knob.

use maud::{Markup, PreEscaped, html};

use super::plot::{INK, Line, Mark, PALETTE, Plot, RED};
use crate::case::Reference;
use crate::error::{Choice, Curve, Point, curves, front};
use crate::session::StudyError;
use crate::{State, Store};

const SIZE_PX: (u32, u32) = (820, 430);

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
    for (curve, color) in curves.iter().zip(PALETTE.into_iter().cycle()) {
        let points = curve.points(store);
        let places: Vec<(f64, f64)> = points.iter().filter_map(place).collect();
        let lost = points.iter().filter(|point| !matches!(point.state, State::Stable | State::Clamped));
        failed.extend(lost.filter_map(|point| point.time_s_per_s.map(|(median, _)| median)));
        all.extend(&places);
        lines.push(Line { name: curve.knob.into(), color, mark: Mark::LineDots, points: places });
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
        title: format!("{}: {}", case.name(), curves[0].method.name),
        x: error_name(curves, store),
        y: "GPU s a simulated s".into(),
        log_x: true,
        log_y: true,
        lines,
        size_px: SIZE_PX,
    }
}

/// What the case's error is called.
fn error_name(curves: &[Curve], store: &Store) -> String {
    let outcomes = curves.iter().flat_map(|curve| &curve.tasks).filter_map(|(_, task)| store.get(task));
    let first = outcomes.filter_map(|outcome| outcome.figures.first()).next();
    first.map_or("error".into(), |figure| {
        if figure.unit.is_empty() { figure.name.clone() } else { format!("{}, {}", figure.name, figure.unit) }
    })
}

/// The section.
pub fn section(choice: &Choice, store: &Store) -> Result<Markup, StudyError> {
    let cases = by_case(choice)?;
    Ok(html! {
        h2 id="error" { "Error against run time" }
        p { "Each curve turns one knob and leaves the rest of the case as it is. Left and low is better; rings are the Pareto front over all knobs of a plot. Times are GPU timestamps of steps after the first ten, evaluation of errors outside. Kinds of reference are never merged." }
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
            details {
                summary { "every point" }
                table {
                    thead { tr { th { "knob" } th { "position" } th { "outcome" } th { "error" } th { "median GPU s/s" } th { "p95" } } }
                    tbody {
                        @for curve in curves {
                            @for point in curve.points(store) {
                                tr class=(class_of(point.state)) {
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
