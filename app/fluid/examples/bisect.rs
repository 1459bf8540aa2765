//! temporary
use brooklet_fluid::particles::{ParticleSet, sample_lattice};
use brooklet_fluid::{FrameRequest, ParticleSource, Scene, Session, SessionRecorder, relax_particles};
use brooklet_gpu::{Gpu, Tier};

fn shake(p: &mut ParticleSet, scene: &Scene, rng: &mut fastrand::Rng, scale: f64) {
    let most_m = 0.5 * 4.0 / 65536.0 * scene.support_m() * scale;
    for position in &mut p.positions {
        for axis in &mut position.position_m {
            *axis = (f64::from(*axis) + most_m * (2.0 * rng.f64() - 1.0)) as f32;
        }
    }
}

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let label = &args[0];
    let seeds: u64 = args[1].parse().unwrap();
    let every: f64 = args[2].parse().unwrap();
    let settings: Vec<String> = args[3..].to_vec();
    let gpu = Gpu::open(&brooklet_gpu::GpuOptions { tier: Some(Tier::Desktop), ..Default::default() }).unwrap();
    let base = Scene::load(
        "falling-ball",
        &[
            "spacing_m=0.0346".into(),
            "outputs.images=0".into(),
            "surface.method=none".into(),
            "outputs.measure_every_steps=1".into(),
        ],
    )
    .unwrap();
    let mut start = sample_lattice(&base);
    relax_particles(&gpu, &base, &mut start).unwrap();
    let mut all = base_settings();
    all.extend(settings);
    let scene = Scene::load("falling-ball", &all).unwrap();
    for seed in 0..seeds {
        let mut p = start.clone();
        let mut rng = fastrand::Rng::with_seed(seed);
        if seed > 0 {
            shake(&mut p, &scene, &mut rng, 1.0);
        }
        let mut session =
            Session::start(&gpu, SessionRecorder::new(&scene, ParticleSource::Given(p)).sweep().unwrap()).unwrap();
        let mut line = Vec::new();
        let mut take = |reports: Vec<brooklet_fluid::SessionReport>| {
            for r in reports {
                if let Some(s) = r.stats {
                    line.push(format!(
                        "[{},{},{},{},{}]",
                        r.steps, s.kinetic_j, s.potential_j, s.compression.mean, s.compression.p99
                    ));
                }
            }
        };
        for step in 1..=240u64 {
            if every > 0.0 {
                let mut p = session.read_particles().unwrap();
                shake(&mut p, &scene, &mut rng, every);
                session.write_particles(&p);
            }
            session.submit(&FrameRequest { steps: 1, measure: step % 6 == 0, ..FrameRequest::default() }).unwrap();
            take(session.reports());
        }
        take(session.finish().unwrap());
        println!("{{\"label\":\"{label}\",\"seed\":{seed},\"m\":[{}]}}", line.join(","));
    }
}

fn base_settings() -> Vec<String> {
    ["spacing_m=0.0346", "outputs.images=0", "surface.method=none", "outputs.measure_every_steps=1"]
        .map(String::from)
        .to_vec()
}
