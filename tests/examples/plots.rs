//! Some plots of the whole study, without the hours of the rest: a part of it, or some cases of that, with all solvers.
//! `cargo run --release -p brooklet-tests --example plots -- FOLDER order|map|validation [CASE ...]`. Outcomes are kept in the
//! folder, so that what was cut off goes on, and the plots beside them; a line is told of each run.

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use brooklet_gpu::{Gpu, Tier};
use brooklet_study::backend::Cache;
use brooklet_study::error::Choice;
use brooklet_study::{Event, Runner, Session, Store, Study, report};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [folder, part, cases @ ..] = &arguments[..] else {
        eprintln!("name a folder and a part");
        return ExitCode::from(2);
    };
    match run(Path::new(folder), part, cases) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn run(folder: &Path, part: &str, cases: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let curves = Choice { cases: Vec::new(), methods: Vec::new(), knobs: Vec::new(), quick: false };
    let study = Study { error: Some(curves), validation: true, precision: false, stability: true, quick: false };
    let mut tasks = study.tasks()?;
    tasks.retain(|task| task.part == part && (cases.is_empty() || cases.contains(&task.case)));
    fs::create_dir_all(folder)?;
    let mut store = Store::open(folder, env!("CARGO_PKG_VERSION"))?;
    let open = |_: Tier, _: bool| -> Result<Gpu, String> { Ok(brooklet_tests::gpu()) };
    let (stop, notify) = (|| false, |_: Event<'_>| {});
    let runner = Runner::new(Session::new(&open, Cache::default(), &stop, &notify));
    for task in &tasks {
        // One at a time, so that its line comes when it ends.
        runner.run(std::slice::from_ref(task), &mut store)?;
        let Some(outcome) = store.get(task) else { continue };
        let figures = outcome.figures.iter().map(|figure| {
            let value = figure.value.map_or("-".into(), |value| format!("{value:.4}"));
            let limit = figure.limit.map_or(String::new(), |limit| format!(" (limit {limit})"));
            format!("{} {value}{limit}", figure.name)
        });
        let told: Vec<String> = figures.collect();
        let (state, reason) = (outcome.state.word(), &outcome.reason);
        println!("{} ({:.0} s): {state} {reason} {}", task.describe(), outcome.wall_s, told.join(", "));
    }
    for (name, svg) in report::plots(&study, &store)? {
        fs::write(folder.join(format!("{name}.svg")), svg)?;
    }
    Ok(())
}
