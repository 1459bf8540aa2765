//! Published cases: figures beside their limits, courses beside what they are held against.

use maud::{Markup, PreEscaped, html};

use super::plot::{INK, Line, Mark, PALETTE, Plot};
use super::work_precision::{class_of, short};
use crate::case::case;
use crate::method::{METHODS, Method};
use crate::{Outcome, Series, Store, Task, Verdict, validation};

/// Told of every run, in the tables beside the page; here they would hide what a case is about.
const OF_EVERY_RUN: [&str; 2] = ["compression", "density error"];

fn found(quick: bool, store: &Store) -> Vec<(&'static Method, Task, &Outcome)> {
    let of = |(method, task): (&'static Method, Task)| {
        let outcome = store.get(&task)?;
        Some((method, task, outcome))
    };
    validation::tasks(quick).into_iter().filter_map(of).collect()
}

/// A course of one case, as each solver has it.
struct Course<'a> {
    case: String,
    of: Vec<(&'static Method, &'a Series)>,
}

impl Course<'_> {
    fn name(&self) -> &str {
        &self.of[0].1.name
    }

    /// All solvers in one plot, each in its colour, and what they are held against.
    fn plot(&self) -> Plot {
        let series = self.of[0].1;
        let reference = if series.measured { ("experiment", Mark::Dots) } else { ("closed form", Mark::Dashed) };
        let line = |name: &str, color, mark, points: &[(f64, f64)]| Line {
            name: name.into(),
            color,
            mark,
            points: points.into(),
        };
        let color = |method: &Method| PALETTE[METHODS.iter().position(|of| of.name == method.name).unwrap_or(0)];
        let solvers = self.of.iter().map(|(method, of)| line(method.name, color(method), Mark::Line, &of.computed));
        Plot {
            title: format!("{}: {}", self.case, series.name),
            x: series.x.clone(),
            y: series.y.clone(),
            lines: solvers.chain([line(reference.0, INK, reference.1, &series.reference)]).collect(),
            size_px: (560, 320),
            ..Plot::default()
        }
    }
}

/// In the order of the cases.
fn courses<'a>(found: &[(&'static Method, Task, &'a Outcome)]) -> Vec<Course<'a>> {
    let mut courses: Vec<Course<'a>> = Vec::new();
    for (method, task, outcome) in found {
        for series in &outcome.series {
            match courses.iter_mut().find(|course| course.case == task.case && course.name() == series.name) {
                Some(course) => course.of.push((method, series)),
                None => courses.push(Course { case: task.case.clone(), of: vec![(method, series)] }),
            }
        }
    }
    courses
}

/// The plots.
pub fn plots(quick: bool, store: &Store) -> Vec<(String, String)> {
    let short = |course: &Course<'_>| course.name().split(' ').next().unwrap_or_default().to_owned();
    let named = |course: &Course<'_>| format!("validation-{}-{}", course.case, short(course));
    courses(&found(quick, store)).iter().map(|course| (named(course), course.plot().svg())).collect()
}

/// How many figures meet their limits, and how many do not.
pub fn counts(quick: bool, store: &Store) -> (usize, usize) {
    let verdicts: Vec<Verdict> = found(quick, store)
        .iter()
        .flat_map(|(_, _, outcome)| outcome.figures.iter().map(|figure| figure.verdict()))
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
            thead { tr { th { "case" } th { "solver" } th { "figure" } th { "reached" } th { "limit" } th { "" } th { "why" } } }
            tbody {
                @for (method, task, outcome) in &found {
                    @if outcome.figures.is_empty() {
                        tr class=(class_of(outcome.state)) { td { (task.case) } td { (method.name) } td colspan="5" { (outcome.state.word()) ": " (outcome.reason) } }
                    }
                    @for (row, figure) in outcome.figures.iter().filter(|figure| !OF_EVERY_RUN.contains(&figure.name.as_str())).enumerate() {
                        tr {
                            td title=(case(&task.case).map_or("", |case| case.summary())) { @if row == 0 { b { (task.case) } } }
                            td { @if row == 0 { (method.name) } }
                            td { (figure.name) }
                            td.number { (figure.value.map_or("–".into(), short)) " " (figure.unit) }
                            td.number { (figure.limit.map_or(String::new(), short)) }
                            td { (pill(figure.verdict())) }
                            td.why { (figure.why) }
                        }
                    }
                }
            }
        }
        div.plots {
            @for course in courses(&found) { (PreEscaped(course.plot().svg())) }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;

    #[test]
    fn a_course_has_all_solvers_in_one_legend() {
        let series = |height| Series {
            name: "front of all".into(),
            x: "t".into(),
            y: "x".into(),
            computed: vec![(0.0, 1.0), (1.0, height)],
            reference: vec![(0.0, 1.0), (1.0, 2.0)],
            measured: true,
        };
        let folder = tempfile::tempdir().unwrap();
        let mut store = Store::open(folder.path(), "test").unwrap();
        for (nth, (_, task)) in
            validation::tasks(false).iter().filter(|(_, task)| task.case == "martin-moyce").enumerate()
        {
            let outcome = Outcome { series: vec![series(2.0 + nth as f64)], ..Outcome::empty(State::Stable, "") };
            store.put(task, outcome).unwrap();
        }
        let plots = plots(false, &store);
        assert_eq!(plots.len(), 1, "one plot a course");
        let (name, svg) = &plots[0];
        assert_eq!(name, "validation-martin-moyce-front");
        for named in METHODS.iter().map(|method| method.name).chain(["experiment"]) {
            assert!(svg.lines().any(|line| line.trim() == named), "{named}: {svg}");
        }
    }
}
