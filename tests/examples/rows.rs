//! The extreme cases by one solver, as a table in Markdown; arguments: the solver, then names of cases (all, without any):
//! `cargo run --release -p brooklet-tests --example rows -- sph jet corner`.

use std::process::ExitCode;

use brooklet_gpu::{Gpu, Tier};
use brooklet_study::backend::Cache;
use brooklet_study::method::method;
use brooklet_study::{Event, Outcome, Runner, Session, Verdict, stability};
use brooklet_tests::gpu;

fn line(name: &str, outcome: &Outcome) -> String {
    let failed = outcome.figures.iter().filter(|figure| figure.verdict() == Verdict::FallsShort);
    let failed: Vec<String> =
        failed.map(|figure| format!("{} {:.3e}", figure.name, figure.value.unwrap_or(f64::NAN))).collect();
    let state = outcome.state.word();
    format!("| {name} | {state} | {} | {} | {:.0} |", outcome.reason, failed.join(", "), outcome.wall_s)
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let Some(method) = arguments.next().as_deref().and_then(method) else {
        eprintln!("name a solver that is studied");
        return ExitCode::from(2);
    };
    let names: Vec<String> = arguments.collect();
    let open = |_: Tier, _: bool| -> Result<Gpu, String> { Ok(gpu()) };
    let (stop, notify) = (|| false, |_: Event<'_>| {});
    let runner = Runner::new(Session::new(&open, Cache::default(), &stop, &notify));
    println!("| case | outcome | said | beyond limits | wall s |\n|---|---|---|---|---|");
    for task in stability::row_tasks(false) {
        // PBF's name no solver, but what is varied.
        let solver = task.settings.iter().find(|setting| setting.starts_with("solver.method="));
        let is_of = solver.map_or(method.name == "pbf", |setting| *setting == method.setting());
        if !is_of || !names.is_empty() && !names.contains(&task.case) {
            continue;
        }
        let began = std::time::Instant::now();
        match runner.outcome(&task) {
            Ok(Some(mut outcome)) => {
                outcome.wall_s = began.elapsed().as_secs_f64();
                let varied = task.settings.iter().filter(|setting| Some(*setting) != solver);
                let varied: Vec<&str> = varied.filter_map(|setting| setting.split('=').nth(1)).collect();
                println!("{}", line(&[&[task.case.as_str()], &varied[..]].concat().join(" "), &outcome));
            }
            Ok(None) => eprintln!("{}: stopped", task.case),
            Err(error) => {
                eprintln!("{}: {error}", task.case);
                return ExitCode::from(2);
            }
        }
    }
    ExitCode::SUCCESS
}
