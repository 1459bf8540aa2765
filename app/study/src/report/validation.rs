//! Published cases: figures beside their limits, courses beside what they are held against.

use maud::{Markup, PreEscaped, html};

use super::plot::{INK, Line, Mark, PALETTE, Plot};
use super::work_precision::{class_of, short};
use crate::case::{WAITING, case};
use crate::{Outcome, Series, Store, Task, Verdict, validation};

/// Told of every run, in the tables beside the page; here they would hide what a case is about.
const OF_EVERY_RUN: [&str; 2] = ["compression", "density error"];

fn found(quick: bool, store: &Store) -> Vec<(Task, &Outcome)> {
    validation::tasks(quick).into_iter().filter_map(|task| Some((task.clone(), store.get(&task)?))).collect()
}

fn plot(task: &Task, series: &Series) -> Plot {
    let reference = if series.measured { ("experiment", Mark::Dots) } else { ("closed form", Mark::Dashed) };
    let line = |name: &str, color, mark, points: &Vec<(f64, f64)>| Line {
        name: name.into(),
        color,
        mark,
        points: points.clone(),
    };
    Plot {
        title: format!("{}: {}", task.case, series.name),
        x: series.x.clone(),
        y: series.y.clone(),
        lines: vec![
            line("brooklet", PALETTE[0], Mark::Line, &series.computed),
            line(reference.0, INK, reference.1, &series.reference),
        ],
        size_px: (560, 320),
        ..Plot::default()
    }
}

/// The plots.
pub fn plots(quick: bool, store: &Store) -> Vec<(String, String)> {
    let mut plots = Vec::new();
    for (task, outcome) in found(quick, store) {
        for series in &outcome.series {
            let name = format!("validation-{}-{}", task.case, series.name.split(' ').next().unwrap_or_default());
            plots.push((name, plot(&task, series).svg()));
        }
    }
    plots
}

/// How many figures meet their limits, and how many do not.
pub fn counts(quick: bool, store: &Store) -> (usize, usize) {
    let verdicts: Vec<Verdict> = found(quick, store)
        .iter()
        .flat_map(|(_, outcome)| outcome.figures.iter().map(|figure| figure.verdict()))
        .collect();
    let of = |wanted: Verdict| verdicts.iter().filter(|verdict| **verdict == wanted).count();
    (of(Verdict::Meets), of(Verdict::FallsShort))
}

/// The section.
pub fn section(quick: bool, store: &Store) -> Markup {
    let found = found(quick, store);
    html! {
        h2 id="validation" { "Validation" }
        p { "Every published case that the solvers can express. Limits were fixed before the first run, but for energy's allowance for what compression gives back; what falls short is shown as falling short." }
        table {
            thead { tr { th { "case" } th { "figure" } th { "reached" } th { "limit" } th { "" } th { "why" } } }
            tbody {
                @for (task, outcome) in &found {
                    @if outcome.figures.is_empty() {
                        tr class=(class_of(outcome.state)) { td { (task.case) } td colspan="5" { (outcome.state.word()) ": " (outcome.reason) } }
                    }
                    @for (row, figure) in outcome.figures.iter().filter(|figure| !OF_EVERY_RUN.contains(&figure.name.as_str())).enumerate() {
                        tr {
                            td title=(case(&task.case).map_or("", |case| case.summary())) { @if row == 0 { b { (task.case) } } }
                            td { (figure.name) }
                            td.number { (figure.value.map_or("–".into(), short)) " " (figure.unit) }
                            td.number { (figure.limit.map_or(String::new(), short)) }
                            td { (pill(figure.verdict())) }
                            td.why { (figure.why) }
                        }
                    }
                }
                @for waiting in WAITING {
                    tr.grey { td { (waiting.name) } td colspan="5" { "waits for " (waiting.needs) } }
                }
            }
        }
        div.plots {
            @for (task, outcome) in &found {
                @for series in &outcome.series { (PreEscaped(plot(task, series).svg())) }
            }
        }
    }
}

/// A verdict as a coloured word.
pub fn pill(verdict: Verdict) -> Markup {
    match verdict {
        Verdict::Meets => html! { span.pill.good { "meets" } },
        Verdict::FallsShort => html! { span.pill.bad { "falls short" } },
        Verdict::Told => html! {},
    }
}
