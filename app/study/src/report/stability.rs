//! The extreme cases and the maps.

use maud::{Markup, PreEscaped, html};

use super::heat::Heat;
use super::work_precision::{class_of, short};
use crate::stability::{Map, ROWS, row_tasks};
use crate::{Outcome, State, Store, Task, Verdict};

fn found(quick: bool, store: &Store) -> Vec<(Task, &Outcome)> {
    row_tasks(quick).into_iter().filter_map(|task| Some((task.clone(), store.get(&task)?))).collect()
}

fn heat(map: Map, quick: bool, store: &Store) -> String {
    let cells = map.cells(quick, store);
    let of_compression =
        |title, x, theory| Heat { title, x, y: "substeps", cells: &cells, range: (1e-3, 0.5), theory, limit: false };
    match map {
        Map::Compression => of_compression(
            "pbf: compression (p99) of a column of 20 layers, and the column law's",
            "iterations a substep",
            "law",
        ),
        Map::Stiffness => of_compression(
            "sph: compression (p99) of the same column, and its equation of state's",
            "stiffness, m²/s²",
            "g H/k",
        ),
        Map::Tolerance => of_compression(
            "dfsph: compression (p99) of the same column, and the tolerance",
            "divergence tolerance",
            "tol.",
        ),
        Map::Relaxation => Heat {
            title: "pbf: kinetic energy over g H of a column that should rest; the line is 2/λmax",
            x: "h/d",
            y: "relaxation ω",
            cells: &cells,
            range: (1e-8, 1e-1),
            theory: "",
            limit: true,
        },
    }
    .svg()
}

/// The maps.
pub fn plots(quick: bool, store: &Store) -> Vec<(String, String)> {
    Map::ALL.into_iter().map(|map| (map.name().to_string(), heat(map, quick, store))).collect()
}

/// How many cells of the matrix ended in each way.
pub fn counts(quick: bool, store: &Store) -> Vec<(State, usize)> {
    let found = found(quick, store);
    let states = [State::Stable, State::Clamped, State::Refused, State::Unstable, State::Silent, State::NotRun];
    let of = |state: State| found.iter().filter(|(_, outcome)| outcome.state == state).count();
    states.into_iter().map(|state| (state, of(state))).filter(|(_, count)| *count > 0).collect()
}

/// The section.
pub fn section(quick: bool, store: &Store) -> Markup {
    let found = found(quick, store);
    html! {
        h2 id="stability" { "Stability" }
        p { "Of PBF every pair of extreme case, precision, tier, order, acceleration and coarse correction meets in at least one run; other solvers run each case as they are. SILENT would be a run that went wrong without the program's own counts or measurements saying so." }
        div.plots {
            @for map in Map::ALL { (PreEscaped(heat(map, quick, store))) }
        }
        table {
            thead { tr { th { "" } th { "case" } th { "expected" } th { "run as" } th { "outcome" } th { "figures beyond limits, or counts" } } }
            tbody {
                @for row in ROWS {
                    @let of: Vec<&(Task, &Outcome)> = found.iter().filter(|(task, _)| task.case == row.name).collect();
                    @for (line, (task, outcome)) in of.iter().enumerate() {
                        tr class=(class_of(outcome.state)) {
                            td { @if line == 0 { (row.number) } }
                            td { @if line == 0 { b { (row.name) } } }
                            td.why { @if line == 0 { (row.expected) } }
                            td { (run_as(task)) }
                            td { (outcome.state.word()) }
                            td.why { (detail(outcome)) }
                        }
                    }
                }
            }
        }
    }
}

fn run_as(task: &Task) -> String {
    let value = |path: &str| {
        task.settings.iter().find_map(|setting| setting.strip_prefix(path)?.strip_prefix('=')).unwrap_or("")
    };
    let mut text = format!("{}, {}", task.tier, value("solver.precision"));
    if value("solver.deterministic") == "true" {
        text.push_str(", deterministic");
    }
    if value("solver.pbf.acceleration") == "none" {
        text.push_str(", plain Jacobi");
    } else if value("solver.pbf.coarse_correction") == "false" {
        text.push_str(", no coarse correction");
    }
    text
}

fn detail(outcome: &Outcome) -> String {
    let beyond = outcome.figures.iter().filter(|figure| figure.verdict() == Verdict::FallsShort);
    let texts: Vec<String> = beyond
        .map(|figure| format!("{} {} {}", figure.name, figure.value.map_or("–".into(), short), figure.unit))
        .collect();
    [texts.join("; "), outcome.reason.clone()]
        .into_iter()
        .filter(|text| !text.is_empty())
        .collect::<Vec<_>>()
        .join(" — ")
}
