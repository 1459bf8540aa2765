//! How each solver comes to rest and stays there: 1,000 particles in a box for 10,000 steps, kinetic energy over m g d of
//! every step to a CSV file and a plot. Arguments: a folder, the number of steps, then solvers (all, without any); of others
//! the plot has what the folder has of them:
//! `cargo run --release -p brooklet-tests --example rest -- rest-curves 10000 dfsph`.

use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;

use brooklet_fluid::{Scene, Session};
use brooklet_study::method::{METHODS, Method, method};
use brooklet_study::report::{Line, Mark, PALETTE, Plot};
use brooklet_tests::pool::POOL;

const G_M_S2: f64 = 9.81;

/// Kinetic energy after each step over what lifting every particle by a spacing takes.
fn course(settings: &[String], steps: u64) -> Result<Vec<f64>, String> {
    let failed = |error: &dyn std::fmt::Display| error.to_string();
    let scene = Scene::from_toml(POOL, "pool", settings).map_err(|error| failed(&error))?;
    let unit_j = scene.particle_mass_kg() * scene.particle_count() as f64 * G_M_S2 * scene.spacing_m;
    let mut session = Session::new(&brooklet_tests::gpu(), &scene).map_err(|error| failed(&error))?;
    let mut course = Vec::new();
    for step in 1..=steps {
        session.step().map_err(|error| failed(&error))?;
        session.measure().map_err(|error| failed(&error))?;
        let frames = session.finish().map_err(|error| failed(&error))?;
        let stats = frames.into_iter().filter_map(|frame| frame.stats).next_back();
        let stats = stats.ok_or_else(|| format!("step {step} was not measured"))?;
        if stats.quarantined > 0 || u64::from(stats.particles) != scene.particle_count() {
            return Err(format!("step {step}: {} particles, {} quarantined", stats.particles, stats.quarantined));
        }
        course.push(stats.kinetic_j / unit_j);
    }
    Ok(course)
}

/// The largest of each of 400 parts of a course: what a plot of 10,000 points shows.
fn thinned(course: &[f64]) -> Vec<(f64, f64)> {
    let every = course.len().div_ceil(400).max(1);
    let largest = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    course.chunks(every).enumerate().map(|(k, part)| ((every * (k + 1)) as f64, largest(part).max(1e-12))).collect()
}

/// The course of a solver that an earlier run left in the folder; none if there is none.
fn kept(path: &Path) -> Result<Option<Vec<f64>>, String> {
    let wrong = |line: &str| format!("{}: '{line}' is no step and energy", path.display());
    let Ok(text) = fs::read_to_string(path) else { return Ok(None) };
    let energy = |line: &str| {
        let value = line.split_once(',').and_then(|(_, energy)| energy.parse::<f64>().ok());
        value.ok_or_else(|| wrong(line))
    };
    text.lines().skip(1).map(energy).collect::<Result<_, _>>().map(Some)
}

/// Runs a solver, and keeps its course.
fn run_one(method: &Method, path: &Path, steps: u64) -> Result<Vec<f64>, String> {
    let written = |error: std::io::Error| format!("{}: {error}", path.display());
    let began = std::time::Instant::now();
    let course = course(&[method.setting()], steps)?;
    let (first, second) = course.split_at(course.len() / 2);
    let largest = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    let ms = began.elapsed().as_secs_f64() * 1e3 / steps as f64;
    println!(
        "| {} | {:.2e} | {:.2e} | {:.2e} | {ms:.1} |",
        method.name,
        largest(first),
        largest(second),
        course.last().copied().unwrap_or(f64::NAN)
    );
    let mut file = std::io::BufWriter::new(fs::File::create(path).map_err(written)?);
    writeln!(file, "step,kinetic_energy_over_m_g_d").map_err(written)?;
    for (step, energy) in course.iter().enumerate() {
        writeln!(file, "{},{energy:e}", step + 1).map_err(written)?;
    }
    file.flush().map_err(written)?;
    Ok(course)
}

fn run(folder: &Path, steps: u64, names: &[String]) -> Result<(), String> {
    let written = |error: std::io::Error| format!("{}: {error}", folder.display());
    if let Some(name) = names.iter().find(|name| method(name).is_none()) {
        return Err(format!("no solver '{name}' is studied"));
    }
    fs::create_dir_all(folder).map_err(written)?;
    let mut lines = Vec::new();
    println!("| solver | largest, first half | largest, second half | end | wall ms a step |\n|---|---|---|---|---|");
    for (method, color) in METHODS.iter().zip(PALETTE) {
        let path = folder.join(format!("{}.csv", method.name));
        let course = match names.is_empty() || names.iter().any(|name| name == method.name) {
            true => Some(run_one(method, &path, steps)?),
            false => kept(&path)?,
        };
        let Some(course) = course else { continue };
        lines.push(Line { name: method.name.into(), color, mark: Mark::Line, points: thinned(&course) });
    }
    let plot = Plot {
        title: "1,000 particles in a box come to rest".into(),
        x: "steps of 1/240 s".into(),
        y: "kinetic energy over m g d".into(),
        log_x: false,
        log_y: true,
        lines,
        size_px: (820, 430),
    };
    fs::write(folder.join("rest.svg"), plot.svg()).map_err(written)
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().unwrap_or_else(|| "rest-curves".into());
    let steps = match arguments.next().as_deref().unwrap_or("10000").parse::<u64>() {
        Ok(steps) if steps > 1 => steps,
        Ok(_) | Err(_) => {
            eprintln!("the number of steps must be a whole number from 2");
            return ExitCode::from(2);
        }
    };
    match run(Path::new(&folder), steps, &arguments.collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("{reason}");
            ExitCode::from(2)
        }
    }
}
