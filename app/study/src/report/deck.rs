//! Convergence of the f64 twins, Jacobi against Gauss-Seidel, iterations against substeps.

use maud::{Markup, PreEscaped, html};

use super::plot::{INK, Line, Mark, PALETTE, Plot};
use super::work_precision::{mark_of, short};
use crate::error::{Convergence, ORDER_CASES, equal_work_tasks, jacobi_tasks, order_tasks, overhead_tasks};
use crate::method::{METHODS, Method};
use crate::{Figure, Outcome, Store, Task};

const SIZE_PX: (u32, u32) = (680, 380);

/// Spacing and error of each f64 run, among `tasks`, of a case by a solver.
fn order(tasks: &[(&Method, Task)], method: &Method, case: &str, error: &str, store: &Store) -> Vec<(f64, f64)> {
    let own = tasks.iter().filter(|(of, task)| of.name == method.name && task.case == case);
    let point = |outcome: &Outcome| Some((outcome.figure("spacing")?.value?, outcome.figure(error)?.value?.abs()));
    own.filter_map(|(_, task)| point(store.get(task)?)).collect()
}

/// Slope of log error over log spacing: least squares. None below two points.
pub fn order_of(points: &[(f64, f64)]) -> Option<f64> {
    if points.len() < 2 {
        return None;
    }
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let n = logs.len() as f64;
    let (mx, my) = (logs.iter().map(|p| p.0).sum::<f64>() / n, logs.iter().map(|p| p.1).sum::<f64>() / n);
    let spread: f64 = logs.iter().map(|p| (p.0 - mx).powi(2)).sum();
    Some(logs.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum::<f64>() / spread)
}

fn order_plot(quick: bool, store: &Store) -> Plot {
    let tasks = order_tasks(quick);
    let mut lines = Vec::new();
    for (&(case, error, _), color) in ORDER_CASES.iter().zip(PALETTE) {
        let mut coarsest: Option<Vec<(f64, f64)>> = None;
        for method in METHODS {
            let points = order(&tasks, method, case.name(), error, store);
            let Some(&(x, y)) = points.first() else { continue };
            let slope = order_of(&points).map_or(String::new(), |order| format!(" ({order:.2})"));
            // A legend is narrow: a case by its last word.
            let what = case.name().rsplit('-').next().unwrap_or_default();
            let name = format!("{} {what}{slope}", method.name);
            coarsest.get_or_insert(points.iter().map(|&(at, _)| (at, y * at / x)).collect());
            lines.push(Line { name, color, mark: mark_of(method), points });
        }
        if let Some(points) = coarsest {
            let name = if lines.iter().any(|line| line.mark == Mark::Dashed) { "" } else { "first order" };
            lines.push(Line { name: name.into(), color: INK, mark: Mark::Dashed, points });
        }
    }
    Plot {
        title: "f64 twins against closed forms".into(),
        x: "spacing, m".into(),
        y: "error".into(),
        log_x: true,
        log_y: true,
        lines,
        size_px: SIZE_PX,
    }
}

fn jacobi_plot(store: &Store) -> Plot {
    let tasks = jacobi_tasks();
    let lines = tasks
        .iter()
        .zip(PALETTE)
        .filter_map(|(task, color)| {
            let convergence = Convergence::of(task, store.get(task)?);
            let points = convergence.left.iter().map(|&(n, left)| (f64::from(n), left)).collect();
            let mark = if convergence.scheme.starts_with("gauss") { Mark::Dashed } else { Mark::LineDots };
            Some(Line { name: convergence.scheme, color, mark, points })
        })
        .collect();
    Plot {
        title: "Jacobi against Gauss-Seidel, in f64".into(),
        x: "sweeps".into(),
        y: "density error inside, root mean square".into(),
        log_x: false,
        log_y: true,
        lines,
        size_px: SIZE_PX,
    }
}

/// Substeps of an equal-work task.
fn substeps(task: &Task) -> f64 {
    let of = |setting: &String| setting.strip_prefix("solver.substeps=")?.parse().ok();
    task.settings.iter().find_map(of).unwrap_or(f64::NAN)
}

fn equal_work(store: &Store) -> Vec<(Task, &Outcome)> {
    equal_work_tasks().into_iter().filter_map(|task| Some((task.clone(), store.get(&task)?))).collect()
}

fn equal_work_plot(store: &Store) -> Plot {
    let found = equal_work(store);
    let mut sizes: Vec<u64> = found.iter().map(|(_, outcome)| outcome.particles).collect();
    sizes.dedup();
    let lines = sizes
        .into_iter()
        .zip(PALETTE)
        .map(|(particles, color)| {
            let of = found.iter().filter(|(_, outcome)| outcome.particles == particles);
            let points = of.filter_map(|(task, outcome)| Some((substeps(task), outcome.error()?))).collect();
            Line { name: format!("{}k particles", particles / 1000), color, mark: Mark::LineDots, points }
        })
        .collect();
    Plot {
        title: "8 iterations a step, spent in one substep or many".into(),
        x: "substeps".into(),
        y: "mean compression".into(),
        log_x: true,
        log_y: true,
        lines,
        size_px: SIZE_PX,
    }
}

/// The plots.
pub fn plots(quick: bool, store: &Store) -> Vec<(String, String)> {
    vec![
        ("order".into(), order_plot(quick, store).svg()),
        ("jacobi".into(), jacobi_plot(store).svg()),
        ("equal-work".into(), equal_work_plot(store).svg()),
    ]
}

/// The section.
pub fn section(quick: bool, store: &Store) -> Markup {
    let found = equal_work(store);
    if plots(quick, store).iter().all(|(_, svg)| svg.is_empty()) {
        return html! {};
    }
    let watching = overhead_tasks(quick).into_iter().find_map(|task| store.get(&task).cloned());
    html! {
        h2 id="convergence" { "Convergence, and how iterations are spent best" }
        div.plots {
            (PreEscaped(order_plot(quick, store).svg()))
            (PreEscaped(jacobi_plot(store).svg()))
            (PreEscaped(equal_work_plot(store).svg()))
        }
        p { "The f64 twins of every kernel, by each solver (PBF with 24 iterations a substep, DFSPH with a tenth of its tolerances), on falling spacings with steps in proportion; the order in brackets is the slope of a straight line through all points." }
        @if !found.is_empty() {
            table {
                thead { tr { th { "particles" } th { "substeps × iterations" } th { "mean compression" } th { "p99" } th { "GPU s/s" } } }
                tbody {
                    @for (task, outcome) in &found {
                        tr {
                            td.number { (outcome.particles) }
                            td { (format!("{0} × {1}", substeps(task), 8.0 / substeps(task))) }
                            td.number { (outcome.error().map_or("–".into(), short)) }
                            td.number { (outcome.figure("mean p99").and_then(|figure| figure.value).map_or("–".into(), short)) }
                            td.number { (outcome.cost.map_or("–".into(), |cost| short(cost.median_s_per_s))) }
                        }
                    }
                }
            }
        }
        @if let Some(watching) = &watching {
            h3 { "What watching costs" }
            table {
                thead { tr { th { "" } th { "" } th { "" } } }
                tbody {
                    @for figure in &watching.figures {
                        tr { td { (figure.name) } td.number { (share(figure)) } td.why { (figure.why) } }
                    }
                }
            }
        }
    }
}

/// Ratios as percent.
fn share(figure: &Figure) -> String {
    match figure.value {
        Some(value) if figure.unit.is_empty() => format!("{:+.1} %", 100.0 * value),
        Some(value) => format!("{value:.2} {}", figure.unit),
        None => "–".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_a_power_is_its_exponent() {
        let points: Vec<(f64, f64)> = [0.1, 0.05, 0.02].map(|x| (x, 3.0 * x * x)).to_vec();
        assert!((order_of(&points).unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(order_of(&points[..1]), None);
    }
}
