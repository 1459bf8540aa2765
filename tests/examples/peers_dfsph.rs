//! DFSPH beside SPlisHSPlasH's, in turns on this machine: the workload of the peers, 31,250 particles, the same density
//! tolerance, wall clocks of the first second. Needs a Python with pySPlisHSPlasH 2.19.0, which BROOKLET_PEERS_PYTHON names;
//! arguments: turns, then settings of ours as `path=value`:
//! `BROOKLET_PEERS_PYTHON=venv/bin/python cargo run --release -p brooklet-tests --example peers_dfsph -- 3`.

use std::ffi::OsString;
use std::process::ExitCode;
use std::time::Instant;

use brooklet_fluid::{Scene, Session};
use brooklet_tests::splishsplash::{self, Solver};
use brooklet_tests::{gpu, peers};

const SPACING_M: f64 = 0.02;
const END_S: f64 = 1.0;

/// Wall time of a second's steps, without the start; and how many steps.
fn ours(scene: &Scene) -> Result<(f64, u32), String> {
    let failed = |error: &dyn std::fmt::Display| error.to_string();
    let mut session = Session::new(&gpu(), scene).map_err(|error| failed(&error))?;
    session.step().and_then(|()| session.finish()).map_err(|error| failed(&error))?;
    let steps = (END_S / scene.solver.dt_s).round() as u32;
    let began = Instant::now();
    for _ in 1..steps {
        session.step().map_err(|error| failed(&error))?;
    }
    session.finish().map_err(|error| failed(&error))?;
    Ok((began.elapsed().as_secs_f64(), steps))
}

fn run(python: &OsString, turns: usize, settings: &[String]) -> Result<(), String> {
    let scene = peers::scene(SPACING_M, &[&["solver.method=dfsph".into()], settings].concat())?;
    let tolerance = scene.solver.dfsph.density_tolerance;
    println!(
        "| ours, s | steps | SPlisHSPlasH's DFSPH, s | steps | ours over theirs | its densities, mean and largest, % |"
    );
    println!("|---|---|---|---|---|---|");
    for _ in 0..turns {
        let (ours_s, steps) = ours(&scene)?;
        let theirs = splishsplash::run(python, Solver::Dfsph(tolerance), SPACING_M, scene.solver.dt_s, END_S)?;
        if theirs.particles != scene.particle_count() {
            return Err(format!("{} particles there, {} here", theirs.particles, scene.particle_count()));
        }
        let theirs_s: f64 = theirs.step_s.iter().sum();
        let [mean, largest] = theirs.density.map(|density| 100.0 * density);
        println!(
            "| {ours_s:.1} | {steps} | {theirs_s:.1} | {} | {:.2} | {mean:.1} and {largest:.1} |",
            theirs.step_s.len() + 1,
            ours_s / theirs_s
        );
    }
    let all = peers::average(&peers::run(&scene)?).all;
    println!(
        "ours: compression {:.2} % mean, {:.2} % for 99 of 100, {:.1} % largest",
        100.0 * all.mean,
        100.0 * all.p99,
        100.0 * all.max
    );
    Ok(())
}

fn main() -> ExitCode {
    let Some(python) = splishsplash::python() else { return ExitCode::SUCCESS };
    let mut arguments = std::env::args().skip(1);
    let turns = match arguments.next().map_or(Ok(3), |text| text.parse::<usize>()) {
        Ok(turns) if turns > 0 => turns,
        _ => {
            eprintln!("turns must be a whole number from 1");
            return ExitCode::from(2);
        }
    };
    match run(&python, turns, &arguments.collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("{reason}");
            ExitCode::from(2)
        }
    }
}
