//! Energy of published cases and of a pool whose substeps are raised, with starts relaxed and as they are placed:
//! `cargo run --release -p brooklet-tests --example energy`.

use brooklet_fluid::{ParticleSource, Scene, Session, SessionRecorder, relax_particles};
use brooklet_study::backend::{Options, run};
use brooklet_study::case::case;
use brooklet_study::{Setup, energy};

fn waves() {
    for (name, settings) in [
        ("standing-wave", &["solver.substeps=1", "solver.substeps=2", "solver.substeps=4", "solver.substeps=8"][..]),
        ("taylor-green", &["solver.substeps=1", "solver.substeps=4", "spacing_m=0.013888888"]),
        ("taylor-green-jittered", &["solver.substeps=1", "solver.substeps=4", "spacing_m=0.013888888"]),
        ("elliptical-drop", &["solver.substeps=1", "solver.substeps=4", "solver.support_ratio=3.5"]),
        ("elliptical-drop", &["solver.support_ratio=2", "solver.support_ratio=4", "spacing_m=0.03125"]),
    ] {
        for (setting, relaxes) in settings.iter().flat_map(|setting| [(setting, false), (setting, true)]) {
            let case = case(name).unwrap();
            let setup = Setup { relaxes, ..case.setup(&[(*setting).into()]).unwrap() };
            let run = run(&brooklet_tests::gpu(), &setup, &Options::default()).unwrap();
            let figures = case.figures(&setup, &run.samples, &|_| None).unwrap();
            let energy = energy::figures(&setup, &run, case.energy_rise());
            let kept = run.samples.last().unwrap().kinetic_m2_s2() / run.start.kinetic_m2_s2();
            let told: Vec<String> = figures
                .iter()
                .chain(&energy)
                .map(|f| format!("{} {:.4}", f.name, f.value.unwrap_or(f64::NAN)))
                .collect();
            println!("{name} {setting} relaxed {relaxes}: {}; kinetic kept {kept:.3}", told.join(", "));
        }
    }
}

const POOL: &str = "
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [1, 1, 0.02]
dimensions = 2
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [1, 0.5, 0.02] }
[solver]
support_ratio = 3
";

fn pool(relaxes: bool, xsph: f64) {
    let at = |substeps: u32| {
        let settings = [format!("solver.substeps={substeps}"), format!("forces.xsph={xsph}")];
        Scene::from_toml(POOL, "pool", &[&settings[..], &["outputs.measure_every_steps=1".into()]].concat()).unwrap()
    };
    let planned = |scene: &Scene, source| {
        let recorder = SessionRecorder::new(scene, source);
        if relaxes { recorder.with_relaxation() } else { recorder }.sweep().unwrap()
    };
    let gpu = brooklet_tests::gpu();
    let mut session = Session::start(&gpu, planned(&at(1), ParticleSource::Scene)).unwrap();
    let told = |session: &mut Session, what: &str| {
        session.measure().unwrap();
        session.finish().unwrap();
        let stats = session.stats().unwrap();
        println!(
            "pool, xsph {xsph}, relaxes {relaxes}, {what}: kinetic {:.4} mJ, potential {:.3} J, fastest {:.3} m/s, compression {:.3} %",
            1e3 * stats.kinetic_j,
            stats.potential_j,
            stats.max_speed_m_s,
            100.0 * stats.compression.mean
        );
    };
    for _ in 0..480 {
        session.step().unwrap();
    }
    told(&mut session, "2 s");
    let mut other = Session::start(&gpu, planned(&at(8), ParticleSource::Count(session.slot_count()))).unwrap();
    let begun = std::time::Instant::now();
    other.adopt(&session).unwrap();
    println!("adopted in {:.0} ms", 1e3 * begun.elapsed().as_secs_f64());
    for steps in [1, 2, 4, 16, 40, 120] {
        for _ in 0..steps {
            other.step().unwrap();
        }
        told(&mut other, &format!("+{steps} steps"));
    }
}

fn starts() {
    for (name, _) in brooklet_fluid::shipped_scenes() {
        let scene = Scene::load(name, &[]).unwrap();
        let mut particles = brooklet_fluid::particles::sample_lattice(&scene);
        let gpu = brooklet_tests::gpu();
        let begun = std::time::Instant::now();
        let done = relax_particles(&gpu, &scene, &mut particles).unwrap();
        println!("{name}: {:.0} ms, {done:?}", 1e3 * begun.elapsed().as_secs_f64());
    }
}

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("pool") => [false, true].into_iter().for_each(|relaxes| {
            pool(relaxes, 0.01);
            pool(relaxes, 0.0);
        }),
        Some("starts") => starts(),
        _ => waves(),
    }
}
