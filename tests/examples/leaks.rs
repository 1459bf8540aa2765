//! Particles that pass solids, which none may: a cup that is carried, tilted and spun; a box that turns around itself; a jet
//! at 100 m/s against a wall as thick as a spacing. `cargo run --release --example leaks -- [CASE] [SETTING ...]`

use brooklet_fluid::{Scene, Session};
use brooklet_kernels::Position;
use brooklet_tests::solids::{LEAKS, Leak};

fn main() {
    let mut settings: Vec<String> = std::env::args().skip(1).collect();
    let named = settings.first().and_then(|name| LEAKS.iter().find(|leak| leak.name == name.as_str()));
    if named.is_some() {
        settings.remove(0);
    }
    for leak in LEAKS.iter().filter(|leak| named.is_none_or(|named| named.name == leak.name)) {
        run(leak, &settings);
    }
}

fn run(leak: &Leak, settings: &[String]) {
    let scene = Scene::from_toml(leak.scene, leak.source, settings).unwrap_or_else(|error| panic!("{error}"));
    let mut session = Session::new(&brooklet_tests::gpu(), &scene).expect("a device");
    let steps = (scene.outputs.seconds / scene.solver.dt_s).round() as u32;
    let (mut most, mut fastest_m_s, mut speed_m_s) = (0, 0.0_f64, 0.0);
    for step in 1..=steps {
        session.step().expect("a step");
        if step % 20 == 0 || step == steps {
            session.measure().expect("a measurement");
            for stats in session.finish().expect("a device").into_iter().filter_map(|report| report.stats) {
                fastest_m_s = fastest_m_s.max(stats.max_speed_m_s);
                speed_m_s = stats.max_speed_m_s;
            }
            let particles = session.read_particles().expect("a device");
            let time_s = f64::from(step) * scene.solver.dt_s;
            let is_through = |at: &&Position| (leak.is_through)(&scene, time_s, at.position_m);
            let through: Vec<&Position> = particles.positions.iter().filter(is_through).collect();
            if let (0, Some(first)) = (most, through.first()) {
                println!("{:12} the first are through at {time_s:.3} s, one at {:?}", leak.name, first.position_m);
            }
            most = most.max(through.len());
        }
    }
    let count = scene.particle_count();
    println!(
        "{:12} {count} particles, {:.1} s, {steps} steps: {most} through; fastest {fastest_m_s:.2} m/s, at the end {speed_m_s:.2}",
        leak.name, scene.outputs.seconds
    );
}
