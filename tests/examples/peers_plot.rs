//! Compression against time on the workload of the peers, with and without what accelerates the iterations, as an SVG.
//! Argument: the file. Times are those of a simulated second, as ratios to plain Jacobi's with four iterations: medians of
//! turns in which both run, one after the other.
//!
//! `cargo run --release -p brooklet-tests --example peers_plot -- peers.svg`

use std::process::ExitCode;

use brooklet_fluid::{Scene, Session};
use brooklet_gpu::Timings;
use brooklet_study::report::{Line, Mark, PALETTE, Plot};
use brooklet_tests::{gpu, peers};

const SPACING_M: f64 = 0.02;
/// Steps that are timed, and those before them.
const STEPS: u64 = 48;
const WARM_UP: u64 = 24;
/// A machine that others load gives ratios that differ by a third from turn to turn.
const TURNS: usize = 3;
/// Steps a second where a point says nothing else: the peers'.
const STEPS_A_SECOND: f64 = 240.0;
/// Name of a curve, what sets it, and along it steps a second and iterations.
type Curve = (&'static str, &'static [&'static str], &'static [(f64, u32)]);
const CURVES: [Curve; 4] = [
    ("plain Jacobi", PLAIN, &[(STEPS_A_SECOND, 2), (STEPS_A_SECOND, 4), (STEPS_A_SECOND, 8)]),
    (
        "with momentum",
        &["solver.pbf.coarse_correction=false"],
        &[(STEPS_A_SECOND, 3), (STEPS_A_SECOND, 4), (STEPS_A_SECOND, 8)],
    ),
    (
        "and coarse correction",
        &[],
        &[(STEPS_A_SECOND, 2), (STEPS_A_SECOND, 3), (STEPS_A_SECOND, 4), (STEPS_A_SECOND, 8)],
    ),
    ("and longer steps", &[], &[(200.0, 2), (160.0, 3), (120.0, 4)]),
];
const PLAIN: &[&str] = &["solver.pbf.acceleration=none", "solver.pbf.coarse_correction=false"];
/// Other programs on this workload with 4 iterations, their own if not PBF: time over plain Brooklet's in one run of both,
/// mean compression by the same yardstick. Measured on two CPU cores, 2026-11-26.
const OTHERS: [(&str, f64, f64); 4] = [
    ("Taichi PBF, CPU", 1.08, 0.13),
    ("Taichi PBF, Vulkan", 1.9, 0.13),
    ("SPlisHSPlasH PBF", 2.6, 0.013),
    ("SPlisHSPlasH DFSPH", 2.7, 0.004),
];

fn main() -> ExitCode {
    let Some(path) = std::env::args().nth(1) else {
        eprintln!("error: name the file that the plot is written to");
        return ExitCode::from(2);
    };
    let written = plot().and_then(|svg| std::fs::write(&path, svg).map_err(|error| format!("{path}: {error}")));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn plot() -> Result<String, String> {
    let plain = scene(PLAIN, (STEPS_A_SECOND, 4))?;
    let mut lines = Vec::new();
    for (curve, (name, settings, along)) in CURVES.into_iter().enumerate() {
        let mut points = Vec::new();
        for &(steps_a_second, iterations) in along {
            let scene = scene(settings, (steps_a_second, iterations))?;
            let ratio = time_ratio(&scene, &plain)? * steps_a_second / STEPS_A_SECOND;
            let all = peers::average(&peers::run(&scene)?).all;
            println!(
                "{name}, {iterations} at {steps_a_second}/s: {ratio:.2} of the time, {:.4} {:.4} {:.4}",
                all.mean, all.p99, all.max
            );
            points.push((ratio, 100.0 * all.mean));
        }
        lines.push(Line { name: name.into(), color: PALETTE[curve], mark: Mark::LineDots, points });
    }
    for (other, (name, ratio, mean)) in OTHERS.into_iter().enumerate() {
        let color = PALETTE[CURVES.len() + other];
        lines.push(Line { name: name.into(), color, mark: Mark::Crosses, points: vec![(ratio, 100.0 * mean)] });
    }
    let plot = Plot {
        title: "a block of water collapses, 31k particles: what its compression costs".into(),
        x: "time of a simulated second, over that of 240 steps of four plain iterations".into(),
        y: "mean compression, %".into(),
        log_x: false,
        log_y: true,
        lines,
        size_px: (860, 460),
    };
    Ok(plot.svg())
}

fn scene(settings: &[&str], (steps_a_second, iterations): (f64, u32)) -> Result<Scene, String> {
    let mut settings: Vec<String> = settings.iter().map(ToString::to_string).collect();
    settings.extend([
        format!("solver.dt_s={}", 1.0 / steps_a_second),
        format!("solver.pbf.iterations={iterations}"),
        "forces.xsph=0".into(),
    ]);
    peers::scene(SPACING_M, &settings)
}

/// Median over turns of a step's time over that of `plain`.
fn time_ratio(scene: &Scene, plain: &Scene) -> Result<f64, String> {
    let mut ratios = (0..TURNS).map(|_| Ok(step_ms(scene)? / step_ms(plain)?)).collect::<Result<Vec<f64>, String>>()?;
    ratios.sort_by(f64::total_cmp);
    Ok(ratios[TURNS / 2])
}

/// Median GPU time of a step.
fn step_ms(scene: &Scene) -> Result<f64, String> {
    let failed = |error: &dyn std::fmt::Display| error.to_string();
    let mut session = Session::new(&gpu(), scene).map_err(|error| failed(&error))?;
    let (step, mut timings) = (session.step_id(), Timings::new(WARM_UP));
    session.finish().map_err(|error| failed(&error))?;
    for _ in 0..WARM_UP + STEPS {
        session.step().map_err(|error| failed(&error))?;
        session.reports().iter().for_each(|frame| timings.add(&frame.report, step));
    }
    let rest = session.finish().map_err(|error| failed(&error))?;
    rest.iter().for_each(|frame| timings.add(&frame.report, step));
    timings.step_ms().map(|step| step.median).ok_or_else(|| "the device gives no times".into())
}
