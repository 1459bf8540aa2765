//! How long what swings takes to: a tank's slowest wave by every solver, and a drop by its surface tension, at three
//! spacings each, beside their closed forms: `cargo run --release -p brooklet-tests --example swings`. Arguments: a case
//! and settings (`path=value`) run that alone.

use std::process::ExitCode;

use brooklet_study::backend::{Options, run};
use brooklet_study::case::case;
use brooklet_study::method::METHODS;

/// The figures of a case with settings, in one line.
fn told(name: &str, settings: &[String]) -> Result<String, String> {
    let case = case(name).ok_or_else(|| format!("there is no case '{name}'"))?;
    let setup = case.setup(settings).map_err(|error| error.to_string())?;
    let began = std::time::Instant::now();
    let run = run(&brooklet_tests::gpu(), &setup, &Options::default()).map_err(|error| error.to_string())?;
    let figures = case.figures(&setup, &run.samples, &|_| None).ok_or("stopped")?;
    let told: Vec<String> = figures.iter().map(|f| format!("{} {:.4}", f.name, f.value.unwrap_or(f64::NAN))).collect();
    let seconds = began.elapsed().as_secs_f64();
    Ok(format!("{} particles, {}, {} ({seconds:.0} s)", setup.count(), told.join(", "), run.counted()))
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let runs: Vec<(String, Vec<String>)> = match arguments.next() {
        Some(name) => vec![(name, arguments.collect())],
        None => all(),
    };
    for (name, settings) in runs {
        match told(&name, &settings) {
            Ok(line) => println!("{name} {}: {line}", settings.join(" ")),
            Err(reason) => {
                eprintln!("{name} {}: {reason}", settings.join(" "));
                return ExitCode::from(2);
            }
        }
    }
    ExitCode::SUCCESS
}

/// Each case at its own spacing, at half of it and at twice.
fn all() -> Vec<(String, Vec<String>)> {
    let of = |name: &str, own: &[String]| {
        let spacing_m = case(name).map_or(f64::NAN, |case| case.spacing_m());
        [2.0, 1.0, 0.5].map(|factor| {
            let spacing = format!("spacing_m={:?}", factor * spacing_m);
            (name.to_owned(), own.iter().cloned().chain([spacing]).collect())
        })
    };
    let waves = METHODS.iter().flat_map(|method| of("standing-wave", &[method.setting()]));
    waves.chain(of("capillary-drop", &[])).collect()
}
