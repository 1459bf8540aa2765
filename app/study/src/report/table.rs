//! Every task a row of CSV, and everything as JSON.

use std::fs::File;
use std::io::{self, BufWriter, Write};

use serde_json::json;

use super::Facts;
use crate::{Store, Task};

/// One row a figure: whoever reads it filters by name.
pub fn csv(to: &mut File, tasks: &[Task], store: &Store) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(BufWriter::new(to));
    csv.write_record([
        "part",
        "case",
        "settings",
        "tier",
        "state",
        "reason",
        "figure",
        "value",
        "unit",
        "limit",
        "verdict",
        "gpu_s_per_s_median",
        "gpu_s_per_s_p95",
        "bytes",
        "particles",
        "device",
        "why",
    ])?;
    for task in tasks {
        let Some(outcome) = store.get(task) else { continue };
        let number = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:e}"));
        let cost = outcome.cost;
        let of_run = |figure: [String; 6]| {
            let [name, value, unit, limit, verdict, why] = figure;
            [
                task.part.clone(),
                task.case.clone(),
                task.settings.join(" "),
                task.tier.clone(),
                outcome.state.word().into(),
                outcome.reason.clone(),
                name,
                value,
                unit,
                limit,
                verdict,
                number(cost.map(|cost| cost.median_s_per_s)),
                number(cost.map(|cost| cost.p95_s_per_s)),
                cost.map_or(String::new(), |cost| cost.bytes.to_string()),
                outcome.particles.to_string(),
                outcome.device.clone(),
                why,
            ]
        };
        if outcome.figures.is_empty() {
            csv.write_record(of_run(Default::default()))?;
        }
        for figure in &outcome.figures {
            csv.write_record(of_run([
                figure.name.clone(),
                number(figure.value),
                figure.unit.clone(),
                number(figure.limit),
                format!("{:?}", figure.verdict()),
                figure.why.clone(),
            ]))?;
        }
    }
    csv.flush()
}

/// Tasks with their outcomes, and where they were found.
pub fn json(to: &mut File, tasks: &[Task], store: &Store, facts: &Facts) -> io::Result<()> {
    let runs: Vec<_> =
        tasks.iter().filter_map(|task| Some(json!({ "task": task, "outcome": store.get(task)? }))).collect();
    let missing = tasks.len() - runs.len();
    let all = json!({
        "program": facts.program,
        "devices": facts.devices,
        "notes": facts.notes,
        "missing": missing,
        "runs": runs,
    });
    let mut to = BufWriter::new(to);
    serde_json::to_writer(&mut to, &all)?;
    to.write_all(b"\n")?;
    to.flush()
}
