//! What each solver says and does where a step, a stiffness or a viscosity is far too large: a small dam break with dt x 10,
//! k x 1000 and nu x 1000, as a table in Markdown. Arguments: solvers (all, without any):
//! `cargo run --release -p brooklet-tests --example extremes -- dfsph`.

use std::process::ExitCode;

use brooklet_fluid::scene::FIELDS;
use brooklet_fluid::{Scene, Session};
use brooklet_study::backend::Counted;
use brooklet_study::method::{METHODS, Method, method};

const DAM: &str = "
spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [1.2, 0.8, 0.4]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.5, 0.6, 0.4] }
[outputs]
measure_every_steps = 1
";
/// Long enough for the front to hit the far wall and to come back.
const SECONDS: f64 = 1.0;
/// A substep's weight is what a user waits for: a run is cut at so many, and that is told.
const MOST_SUBSTEPS: u64 = 24_000;

/// A way to run a solver that changes how it answers, beside its default.
const WAYS: &[(&str, &str, &[&str])] =
    &[("sph", "fixed substeps", &["solver.sph.adaptive_substeps=false", "solver.substeps=16"])];

/// What is turned.
struct Trial {
    name: &'static str,
    settings: Vec<String>,
}

/// The setting of a solver that is turned, of those there are; none if it has no such term.
fn path_of(method: &Method, ends: &[&str]) -> Option<&'static str> {
    let own = |path: &str| ends.iter().any(|end| path == *end || path == format!("solver.{}.{end}", method.name));
    FIELDS.iter().find(|field| field.is_of(method.name) && own(field.path)).map(|field| field.path)
}

fn trials(method: &Method, scene: &Scene) -> Vec<Trial> {
    // The viscosity that acts, what a solver needs to stay calm included.
    let stiffness = path_of(method, &["stiffness_m2_s2"]).map(|path| (path, scene.stiffness_m2_s2()));
    let viscosity = path_of(method, &["viscosity_m2_s"]).map(|path| (path, scene.sph_viscosity_m2_s()));
    let viscosity = viscosity.or(path_of(method, &["forces.xsph"]).map(|path| (path, scene.forces.xsph)));
    let times = |of: Option<(&str, f64)>, factor: f64| of.map(|(path, value)| format!("{path}={:e}", factor * value));
    let all = [
        ("as it is", Some(format!("solver.dt_s={:?}", scene.solver.dt_s))),
        ("dt x 10", Some(format!("solver.dt_s={:?}", 10.0 * scene.solver.dt_s))),
        ("k x 1000", times(stiffness, 1000.0)),
        ("nu x 10", times(viscosity, 10.0)),
        ("nu x 1000", times(viscosity, 1000.0)),
    ];
    // What a solver does not have it refuses, with whose it is.
    let none = |name: &str| match name.starts_with('k') {
        true => "solver.sph.stiffness_m2_s2=1e5".into(),
        false => "solver.sph.viscosity_m2_s=1e3".into(),
    };
    all.into_iter()
        .map(|(name, setting)| Trial { name, settings: vec![setting.unwrap_or_else(|| none(name))] })
        .collect()
}

/// What a run does and says.
fn outcome(settings: &[String]) -> Result<String, String> {
    let failed = |error: &dyn std::fmt::Display| error.to_string();
    let scene = Scene::from_toml(DAM, "dam", settings).map_err(|error| format!("refused: {error}"))?;
    let mut session = Session::new(&brooklet_tests::gpu(), &scene).map_err(|error| failed(&error))?;
    let wanted = (SECONDS / scene.solver.dt_s).ceil() as u64;
    let steps = wanted.min(MOST_SUBSTEPS / u64::from(scene.substeps())).max(4);
    let mut speed_m_s = 0.0_f64;
    let mut worst = 0.0_f64;
    let mut counted = Counted::default();
    let mut last = None;
    for _ in 0..steps {
        session.step().map_err(|error| failed(&error))?;
        session.measure().map_err(|error| failed(&error))?;
        for stats in session.finish().map_err(|error| failed(&error))?.into_iter().filter_map(|frame| frame.stats) {
            counted = counted.and(&stats.counters);
            // f64::max would drop a NaN.
            speed_m_s = if stats.max_speed_m_s > speed_m_s || stats.max_speed_m_s.is_nan() {
                stats.max_speed_m_s
            } else {
                speed_m_s
            };
            worst = worst.max(stats.compression.p99);
            last = Some(stats);
        }
    }
    let last = last.ok_or("nothing was measured")?;
    let particles = session.read_particles().map_err(|error| failed(&error))?;
    let finite = particles.positions.iter().all(|p| p.position_m.iter().all(|x| x.is_finite()))
        && particles.velocities.iter().all(|v| v.velocity_m_s.iter().all(|x| x.is_finite()));
    let says = told(&counted);
    let cut =
        if steps < wanted { format!(" (until {:.3} s)", steps as f64 * scene.solver.dt_s) } else { String::new() };
    Ok(format!(
        "{says} | {} of {:.2e} s{cut} | {speed_m_s:.2} of {:.2} | {:.1} % | {:.2} m/s, {:.1} % | {}, {} quarantined",
        scene.substeps(),
        scene.substep_s(),
        scene.max_speed_m_s(),
        100.0 * worst,
        last.max_speed_m_s,
        100.0 * last.compression.p99,
        if finite { "finite" } else { "NOT FINITE" },
        last.quarantined
    ))
}

/// The counts that are not 0.
fn told(counted: &Counted) -> String {
    let all = [
        (counted.long_substeps, "substeps above their limit"),
        (counted.speed_clamps, "speeds clamped"),
        (counted.correction_clamps, "corrections clamped"),
        (counted.displacement_clamps, "displacements held"),
        (counted.neighbour_overflow, "neighbours without a slot"),
        (counted.crowded, "crowded searches"),
    ];
    let parts: Vec<String> =
        all.into_iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    match (counted.long_substeps, parts.is_empty()) {
        (_, true) => "nothing".into(),
        (0, _) => parts.join(", "),
        _ => format!("unstable: {}", parts.join(", ")),
    }
}

fn main() -> ExitCode {
    let names: Vec<String> = std::env::args().skip(1).collect();
    if let Some(name) = names.iter().find(|name| method(name).is_none()) {
        eprintln!("no solver '{name}' is studied");
        return ExitCode::from(2);
    }
    println!(
        "| solver | turned | says | substeps a step at most | fastest, m/s, of limit | compression p99 | at the end | state |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for method in METHODS.iter().filter(|method| names.is_empty() || names.iter().any(|name| name == method.name)) {
        let default = ("", &[][..]);
        let own = WAYS.iter().filter(|(of, ..)| *of == method.name).map(|&(_, name, settings)| (name, settings));
        for (way, more) in std::iter::once(default).chain(own) {
            let more: Vec<String> =
                std::iter::once(method.setting()).chain(more.iter().map(|&setting| setting.into())).collect();
            let scene = match Scene::from_toml(DAM, "dam", &more) {
                Ok(scene) => scene,
                Err(error) => {
                    eprintln!("{error}");
                    return ExitCode::from(2);
                }
            };
            for Trial { name, settings } in trials(method, &scene) {
                let line = outcome(&[more.clone(), settings].concat());
                let line = line.unwrap_or_else(|reason| format!("{reason} | | | | |"));
                println!("| {} {way} | {name} | {line} |", method.name);
            }
        }
    }
    ExitCode::SUCCESS
}
