//! `brooklet tune`: the cheapest setting of a scene for an error, or the most exact one for a time.

use std::path::PathBuf;

use brooklet_study::tune::{Candidate, Found, Goal, MOST_TRIED_IN_ALL, Tried, TuneError, tune as search};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use crate::{
    failure::Failure, interrupt::Interrupt, job, out_dir::write_file, study_options::TuneOptions, table::table,
};

/// Searches, checks, prints and writes the scene.
pub fn tune(options: &TuneOptions) -> Result<(), Failure> {
    let scene = job::load(&options.scene, &options.settings)?;
    let goal = match (options.budget_ms, options.max_error) {
        (Some(ms), _) => Goal::BudgetMs(ms),
        (None, Some(error)) => Goal::MaxError(error),
        (None, None) => return Err(Failure::Input("give --budget-ms or --max-error".into())),
    };
    let out = options.out.clone().unwrap_or_else(|| PathBuf::from(format!("{}-tuned.toml", scene.name)));
    if out.exists() && options.out.is_none() {
        return Err(Failure::Input(format!("{} exists and is kept; name another file with --out", out.display())));
    }
    let gpu = job::open(&options.device, true)?;
    let interrupt = Interrupt::listen()?;
    let bar = ProgressBar::new(MOST_TRIED_IN_ALL as u64 + 1);
    let style = ProgressStyle::with_template("{bar:32} at most {len} runs, {pos} done  {wide_msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let mut told = |tried: &Tried| {
        bar.inc(1);
        bar.set_message(line(tried));
    };
    let found = search(&gpu, &scene, goal, &options.methods, options.seconds, &|| interrupt.is_pressed(), &mut told);
    bar.finish_and_clear();
    let failed = |error| match error {
        TuneError::Stopped => Failure::Interrupted("nothing was written".into()),
        TuneError::Nothing(text) => Failure::Input(text),
        TuneError::Run(error) => Failure::input(error),
    };
    let found = found.map_err(failed)?;
    let tuned = found.chosen.candidate.apply(&scene).map_err(failed)?;
    write_file(&out, tuned.to_toml().as_bytes())?;
    if options.json {
        say!("{}", as_json(&found, goal, &out));
    } else {
        print(&found, goal);
        say!("scene     {}", out.display());
    }
    if found.meets {
        return Ok(());
    }
    let nearest = "the goal cannot be met within the search; the setting nearest to it was written";
    Err(Failure::Stopped(nearest.into()))
}

fn line(tried: &Tried) -> String {
    let Tried { step_ms, error, .. } = tried;
    let candidate = match tried.candidate {
        Candidate::Pbf(iterated) => iterated,
        Candidate::Other(rung) => {
            return format!("{}, {}: {step_ms:.2} ms, error {:.2} %", rung.method, rung.name, 100.0 * error);
        }
    };
    let plain = match (candidate.accelerated, candidate.coarse) {
        (true, true) => "",
        (true, false) => ", no coarse correction",
        (false, _) => ", not accelerated",
    };
    let warm = if candidate.warm { ", warm start" } else { "" };
    let relaxed = if candidate.relaxed { ", relaxed" } else { "" };
    format!(
        "pbf, {} x {}{plain}{warm}{relaxed}: {step_ms:.2} ms, error {:.2} %",
        candidate.substeps,
        candidate.iterations,
        100.0 * error
    )
}

fn print(found: &Found, goal: Goal) {
    let mut rows = found.tried.clone();
    rows.sort_by(|a, b| a.step_ms.total_cmp(&b.step_ms));
    let heads =
        ["solver", "substeps", "iterations", "accelerated", "coarse", "warm", "relaxed", "step ms", "error %", ""];
    let mut shown = table(&heads, &[1, 2, 7, 8]);
    for tried in &rows {
        let beaten = rows.iter().any(|other| other.step_ms < tried.step_ms && other.error <= tried.error);
        let mark = match (tried.candidate == found.chosen.candidate, beaten) {
            (true, _) => "chosen",
            (false, false) => "front",
            (false, true) => "",
        };
        let yes = |is: bool| String::from(if is { "yes" } else { "no" });
        let setting = match tried.candidate {
            Candidate::Pbf(at) => [
                at.substeps.to_string(),
                at.iterations.to_string(),
                yes(at.accelerated),
                yes(at.coarse),
                yes(at.warm),
                yes(at.relaxed),
            ],
            Candidate::Other(rung) => [rung.name.into(), "-".into(), "-".into(), "-".into(), "-".into(), "-".into()],
        };
        let solver = std::iter::once(tried.candidate.method().to_string());
        let cost = [format!("{:.2}", tried.step_ms), format!("{:.3}", 100.0 * tried.error), mark.into()];
        shown.add_row(solver.chain(setting).chain(cost));
    }
    say!("{shown}\n");
    for (solver, times) in &found.passed_over {
        say!("not run   {solver}: by the table of error against time it takes {times:.0} times as long for this error");
    }
    match goal {
        Goal::BudgetMs(ms) => say!("goal      the smallest error within {ms} ms a step"),
        Goal::MaxError(error) => say!("goal      the shortest step with an error of {} % at most", 100.0 * error),
    }
    say!("found     {}", line(&found.chosen));
    say!("checked   {}", line(&found.checked));
}

fn as_json(found: &Found, goal: Goal, out: &std::path::Path) -> String {
    let one = |tried: &Tried| match tried.candidate {
        Candidate::Pbf(at) => json!({
            "solver": "pbf",
            "substeps": at.substeps,
            "iterations": at.iterations,
            "accelerated": at.accelerated,
            "coarse_correction": at.coarse,
            "warm_start": at.warm,
            "relaxed": at.relaxed,
            "step_ms": tried.step_ms,
            "error": tried.error,
        }),
        Candidate::Other(rung) => json!({
            "solver": rung.method,
            "setting": rung.name,
            "step_ms": tried.step_ms,
            "error": tried.error,
        }),
    };
    let goal = match goal {
        Goal::BudgetMs(ms) => json!({ "budget_ms": ms }),
        Goal::MaxError(error) => json!({ "max_error": error }),
    };
    let all = json!({
        "goal": goal,
        "meets": found.meets,
        "chosen": one(&found.chosen),
        "checked": one(&found.checked),
        "passed_over": found.passed_over.iter().map(|(solver, times)| json!({ "solver": solver, "times_of_pbf": times })).collect::<Vec<_>>(),
        "tried": found.tried.iter().map(one).collect::<Vec<_>>(),
        "scene": out.display().to_string(),
    });
    serde_json::to_string_pretty(&all).unwrap_or_default()
}
