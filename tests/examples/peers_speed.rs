//! A step of SPH beside one of SPlisHSPlasH's WCSPH, in turns on this machine: the workload of the peers at 27,648 and
//! 128,000 particles, the same fixed step and speed of sound, wall clocks. Eight of theirs are one of ours, its substeps, most of
//! which keep their lists. Needs a Python with pySPlisHSPlasH 2.19.0, which
//! BROOKLET_PEERS_PYTHON names; arguments: turns, steps:
//! `BROOKLET_PEERS_PYTHON=venv/bin/python cargo run --release -p brooklet-tests --example peers_speed -- 3 30`.

use std::ffi::OsString;
use std::process::ExitCode;
use std::time::Instant;

use brooklet_fluid::{Scene, Session};
use brooklet_tests::splishsplash::{self, Solver};
use brooklet_tests::{gpu, peers};

const SPACINGS_M: [f64; 2] = [1.0 / 48.0, 1.0 / 80.0];
/// The first sort, build and allocate.
const WARM_UP: usize = 3;
/// Of the longest substep that sound allows.
const OF_THE_LIMIT: f64 = 0.8;
/// Of one of our steps: each is one of theirs.
const SUBSTEPS: usize = 8;

fn scene(spacing_m: f64, settings: &[String]) -> Result<Scene, String> {
    peers::scene(spacing_m, &[&["solver.method=sph".into()], settings].concat())
}

/// Seconds of wall time that each of `steps` steps takes, behind the warm-up, and the largest compression.
fn ours(scene: &Scene, steps: usize) -> Result<(Vec<f64>, f64), String> {
    let failed = |error: &dyn std::fmt::Display| error.to_string();
    let mut measured = scene.clone();
    measured.outputs.measure_every_steps = 1;
    let mut session = Session::new(&gpu(), &measured).map_err(|error| failed(&error))?;
    let mut step_s = Vec::new();
    for _ in 0..steps {
        session.finish().map_err(|error| failed(&error))?;
        let began = Instant::now();
        session.step().map_err(|error| failed(&error))?;
        session.finish().map_err(|error| failed(&error))?;
        step_s.push(began.elapsed().as_secs_f64());
    }
    session.measure().map_err(|error| failed(&error))?;
    session.finish().map_err(|error| failed(&error))?;
    let stats = session.stats().ok_or("nothing was measured")?;
    if stats.counters.long_substeps > 0 {
        return Err(format!("{} substeps were above their limit", stats.counters.long_substeps));
    }
    Ok((step_s.split_off(WARM_UP), stats.compression.max))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn run(python: &OsString, turns: usize, steps: usize) -> Result<(), String> {
    println!(
        "| particles | step, ms | ours, ms a step | SPlisHSPlasH WCSPH, ms a step | theirs over ours, each turn | \
         a simulated second, ours choosing its substeps: theirs over ours | largest compression, % |\n|---|---|---|---|---|---|---|"
    );
    for spacing_m in SPACINGS_M {
        let free = scene(spacing_m, &["solver.sph.adaptive_substeps=false".into()])?;
        let dt_s = OF_THE_LIMIT * free.sound_limit_s().min(free.steady_limit_s());
        let (substeps, step) =
            (format!("solver.substeps={SUBSTEPS}"), format!("solver.dt_s={:?}", SUBSTEPS as f64 * dt_s));
        let fixed = scene(spacing_m, &["solver.sph.adaptive_substeps=false".into(), substeps, step])?;
        let chosen = scene(spacing_m, &[])?;
        let sound_m_s = free.stiffness_m2_s2().sqrt();
        let (mut own, mut other, mut ratios, mut a_second) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut compression = [0.0_f64; 2];
        for _ in 0..turns {
            let own_steps = steps.div_ceil(SUBSTEPS) + WARM_UP;
            let (mut ours_s, ours_most) = ours(&fixed, own_steps)?;
            ours_s.iter_mut().for_each(|step_s| *step_s /= SUBSTEPS as f64);
            let end_s = (own_steps * SUBSTEPS) as f64 * dt_s;
            let theirs = splishsplash::run(python, Solver::Wcsph(sound_m_s), spacing_m, dt_s, end_s)?;
            if theirs.particles != fixed.particle_count() {
                return Err(format!("{} particles there, {} here", theirs.particles, fixed.particle_count()));
            }
            let theirs_s = theirs.step_s[WARM_UP - 1..].to_vec();
            let (chosen_s, _) = ours(&chosen, WARM_UP + 3)?;
            let [ours_ms, theirs_ms, chosen_ms] = [ours_s, theirs_s, chosen_s].map(|all| 1e3 * median(all));
            ratios.push(theirs_ms / ours_ms);
            a_second.push(theirs_ms / dt_s / (chosen_ms / chosen.solver.dt_s));
            own.push(ours_ms);
            other.push(theirs_ms);
            compression = [compression[0].max(ours_most), compression[1].max(theirs.density[1] - 1.0)];
        }
        let shown = |all: &[f64]| all.iter().map(|ratio| format!("{ratio:.2}")).collect::<Vec<_>>().join(", ");
        println!(
            "| {} | {:.3} | {:.1} | {:.1} | {} | {} | {:.1} and {:.1} |",
            fixed.particle_count(),
            1e3 * dt_s,
            median(own),
            median(other),
            shown(&ratios),
            shown(&a_second),
            100.0 * compression[0],
            100.0 * compression[1]
        );
    }
    Ok(())
}

fn main() -> ExitCode {
    let Some(python) = splishsplash::python() else { return ExitCode::SUCCESS };
    let mut arguments = std::env::args().skip(1).map(|text| text.parse::<usize>());
    let mut next = |default| arguments.next().unwrap_or(Ok(default));
    let (turns, steps) = match (next(3), next(30)) {
        (Ok(turns), Ok(steps)) if turns > 0 && steps > 0 => (turns, steps),
        _ => {
            eprintln!("turns and steps must be whole numbers from 1");
            return ExitCode::from(2);
        }
    };
    match run(&python, turns, steps) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("{reason}");
            ExitCode::from(2)
        }
    }
}
