//! What walls cost the fluid: channels at three spacings, and two published dam breaks over a floor of rising friction; with
//! `models`, how each solver's pool of 1,000 rests on each model of walls:
//! `cargo run --release -p brooklet-tests --example walls [-- models]`.

use brooklet_fluid::scene::WallModel;
use brooklet_fluid::{Scene, Session};
use brooklet_kernels::Position;
use brooklet_study::backend::{Options, run};
use brooklet_study::case::case;
use brooklet_tests::gpu_of_long_run;
use brooklet_tests::pool::POOL;

/// The figures of a case with settings, in one line.
fn told(name: &str, settings: &[String]) -> String {
    let case = case(name).unwrap();
    let setup = case.setup(settings).unwrap();
    let run = run(&brooklet_tests::gpu(), &setup, &Options::default()).unwrap();
    let figures = case.figures(&setup, &run.samples, &|_| None).unwrap();
    let told: Vec<String> = figures.iter().map(|f| format!("{} {:.4}", f.name, f.value.unwrap_or(f64::NAN))).collect();
    told.join(", ")
}

const STEPS: u32 = 480;

/// A row of a table: how a pool is after two seconds.
fn rested(method: &str, model: &str) -> Result<String, Box<dyn std::error::Error>> {
    let settings = [format!("solver.method={method}"), format!("domain.wall.model={model}")];
    let scene = Scene::from_toml(POOL, "pool", &settings)?;
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene)?;
    let began = std::time::Instant::now();
    for _ in 0..STEPS {
        session.step()?;
    }
    let after = session.read_particles()?;
    let step_ms = began.elapsed().as_secs_f64() * 1e3 / f64::from(STEPS);
    session.measure()?;
    let stats = session.finish()?.into_iter().filter_map(|frame| frame.stats).next_back().ok_or("not measured")?;
    let d_m = scene.spacing_m;
    let unit_j = scene.particle_mass_kg() * scene.particle_count() as f64 * 9.81 * d_m;
    let mut heights_m: Vec<f64> = after.positions.iter().map(|at| f64::from(at.position_m[1])).collect();
    heights_m.sort_unstable_by(f64::total_cmp);
    let layer = &heights_m[..100];
    let lowest = layer.iter().sum::<f64>() / 100.0 / d_m;
    let middle_m = heights_m.iter().sum::<f64>() / heights_m.len() as f64;
    // Of a lattice a column of 10 x 10 has 36 beside its sides.
    let beside = |at: &Position| [0, 2].iter().any(|&k| !(0.02..=0.18).contains(&at.position_m[k]));
    let crowd = after.positions.iter().filter(|at| beside(at)).count() as f64 / 360.0;
    Ok(format!(
        "| {method} | {model} | {:.1e} | {lowest:.2} | {:.1} | {crowd:.2} | {:.1} | {step_ms:.1} |",
        stats.kinetic_j / unit_j,
        100.0 * (1.0 - middle_m / 0.1),
        100.0 * stats.compression.p99,
    ))
}

fn models() {
    println!(
        "| solver | model | kinetic energy / m g d | lowest layer, d | height lost, % | beside sides | 99 % of compression | wall ms a step |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for (method, model) in
        ["pbf", "sph"].iter().flat_map(|method| WallModel::NAMES.iter().map(move |model| (method, model)))
    {
        match rested(method, model) {
            Ok(row) => println!("{row}"),
            Err(error) => println!("| {method} | {model} | {error} |"),
        }
    }
}

fn main() {
    if std::env::args().nth(1).as_deref() == Some("models") {
        return models();
    }
    for (name, spacing_m) in ["couette", "poiseuille"].iter().flat_map(|name| [0.1, 0.05, 0.025].map(|d| (name, d))) {
        println!("{name} d = {spacing_m} H: {}", told(name, &[format!("spacing_m={spacing_m}")]));
    }
    for name in ["square-column", "martin-moyce"] {
        for friction in [0.0, 0.003, 0.005, 0.006, 0.007, 0.008, 0.014, 0.03] {
            let settings = ["slip=friction".into(), format!("friction={friction}")];
            let settings = settings.map(|setting| format!("domain.faces.y_min.{setting}"));
            println!("{name} c_f {friction}: {}", told(name, &settings));
        }
    }
}
