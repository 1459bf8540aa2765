//! Solids that stand and move: nobody passes one, and fluid at one is as dense as fluid elsewhere.

use brooklet_fluid::{Scene, Session};
use brooklet_tests::solids::{BOWL, BOX, CUP, HILLS, JET, Leak};
use brooklet_tests::{gpu_of_long_run, small};

fn scene(leak: &Leak, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    Scene::from_toml(leak.scene, leak.source, &settings).unwrap()
}

/// Runs for so many steps, and returns how many particles are through at the end.
fn through(leak: &Leak, settings: &[&str], steps: u32) -> usize {
    let scene = scene(leak, settings);
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    for _ in 0..steps {
        session.step().unwrap();
    }
    let particles = session.read_particles().unwrap();
    let time_s = f64::from(steps) * scene.solver.dt_s;
    assert!(!particles.positions.is_empty());
    particles.positions.iter().filter(|at| (leak.is_through)(&scene, time_s, at.position_m)).count()
}

/// The whole of each motion, 10 s, is the example `leaks`.
#[test]
fn nobody_passes_a_wall_of_one_spacing() {
    let (coarse, steps) = if small() { ("spacing_m=0.04", 10) } else { ("spacing_m=0.025", 60) };
    // As thick as a spacing.
    let thickness = coarse.replace("spacing_m", "solid.0.thickness_m");
    for method in ["solver.method=pbf", "solver.method=none", "solver.method=sph", "solver.method=dfsph"] {
        for leak in [&CUP, &BOX] {
            assert_eq!(through(leak, &[coarse, &thickness, method], steps), 0, "{} with {method}", leak.name);
        }
    }
    assert_eq!(through(&JET, &[coarse, "solid.0.box.size_m.0=0.025"], steps / 2), 0, "jet");
    assert_eq!(through(&JET, &[coarse, "solver.method=none"], steps / 2), 0, "jet of particles alone");
}

/// A bowl of triangles, two thirds of a spacing thick, and ground.
#[test]
fn nobody_passes_triangles() {
    let steps = if small() { 5 } else { 60 };
    for method in ["solver.method=pbf", "solver.method=none", "solver.method=sph", "solver.method=dfsph"] {
        assert_eq!(through(&BOWL, &["spacing_m=0.03", method], steps), 0, "bowl with {method}");
        assert_eq!(through(&HILLS, &[method], steps), 0, "hills with {method}");
    }
    // Without the bowl, which the rod's number then is.
    let scene = scene(&BOWL, &["spacing_m=0.04", "solver.method=none"]);
    let mut open = scene.clone();
    open.solids.remove(0);
    let mut session = Session::new(&gpu_of_long_run(&open), &open).unwrap();
    for _ in 0..60 {
        session.step().unwrap();
    }
    let particles = session.read_particles().unwrap();
    let through = particles.positions.iter().filter(|at| (BOWL.is_through)(&scene, 0.25, at.position_m)).count();
    assert!(through > 30, "{through} of {} through", particles.positions.len());
}

/// A pool over hills comes to rest, and none of it is in the ground.
#[test]
fn a_pool_over_ground_rests() {
    let steps = if small() { 10 } else { 360 };
    let scene = scene(&HILLS, &["outputs.measure_every_steps=1"]);
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    for _ in 0..steps {
        session.step().unwrap();
    }
    session.measure().unwrap();
    let stats = session.finish().unwrap().into_iter().filter_map(|report| report.stats).next_back().unwrap();
    println!("{stats:?}");
    let mass_kg = stats.particles as f64 * scene.particle_mass_kg();
    let speed_m_s = (2.0 * stats.kinetic_j / mass_kg).sqrt();
    // What a particle that falls by half a spacing has.
    let fallen_m_s = (scene.gravity_length_m_s2() * scene.spacing_m).sqrt();
    assert!(speed_m_s < fallen_m_s * if small() { 1.0 } else { 0.1 }, "{speed_m_s} m/s on average");
    assert!(stats.compression.mean < 0.01, "{:?}", stats.compression);
}

/// The comparator that all of the above rest on.
#[test]
fn without_the_solid_particles_are_through() {
    let scene = scene(&JET, &["spacing_m=0.04"]);
    let mut open = scene.clone();
    open.solids.clear();
    let mut session = Session::new(&gpu_of_long_run(&open), &open).unwrap();
    for _ in 0..4 {
        session.step().unwrap();
    }
    let particles = session.read_particles().unwrap();
    let through = particles.positions.iter().filter(|at| (JET.is_through)(&scene, 0.1, at.position_m)).count();
    assert!(through > 100, "{through} through");
}

/// Water in a box that stands in the domain rests as water in the domain's own box does.
#[test]
fn a_box_that_stands_is_as_calm_and_dense_as_walls_are() {
    let steps = if small() { 10 } else { 120 };
    let run = |method: &str, solid: &str, domain: &str| {
        let text = format!(
            "spacing_m = 0.04\n[domain]\n{domain}\n[[fluid]]\nblock = {{ min_m = [0.4, 0.4, 0.4], max_m = [0.8, 0.72, 0.8] }}\n\
             {solid}[outputs]\nmeasure_every_steps = 1\n"
        );
        let scene = Scene::from_toml(&text, "calm", &[format!("solver.method={method}")]).unwrap();
        let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
        for _ in 0..steps {
            session.step().unwrap();
        }
        session.measure().unwrap();
        session.finish().unwrap().into_iter().filter_map(|report| report.stats).next_back().unwrap()
    };
    let solid = "[[solid]]\nbox = { size_m = [0.48, 0.48, 0.48] }\nthickness_m = 0.04\ncentre_m = [0.6, 0.6, 0.6]\n";
    // DFSPH mirrors the fluid in one plane a particle, where it mirrors it in as many walls as are near: by .06 m/s less calm.
    for (method, restless_j) in [("pbf", 1e-3), ("dfsph", 0.2)] {
        let walls = run(method, "", "min_m = [0.4, 0.4, 0.4]\nmax_m = [0.8, 0.8, 0.8]");
        let solids = run(method, solid, "min_m = [0, 0, 0]\nmax_m = [1.2, 1.2, 1.2]");
        assert_eq!(solids.particles, walls.particles);
        println!("{method}: walls {walls:?}\nsolids {solids:?}");
        assert!(solids.compression.mean < 2.0 * walls.compression.mean + 0.002);
        assert!(solids.density_error.mean < walls.density_error.mean + 0.02);
        let (kinetic_j, of_walls_j) = (solids.kinetic_j, walls.kinetic_j);
        assert!(kinetic_j < 4.0 * of_walls_j + restless_j, "{method}: {kinetic_j} J and {of_walls_j} J");
    }
}

#[test]
fn a_scene_without_solids_has_nothing_of_them() {
    use brooklet_fluid::{ParticleSource, SessionRecorder};
    let plan = |settings: &[&str]| {
        let mut scene = scene(&CUP, settings);
        if settings.is_empty() {
            scene.solids.clear();
        }
        let planned = SessionRecorder::new(&scene, ParticleSource::Count(1000)).sweep().unwrap();
        format!("{:?}", planned.plan.passes().into_iter().map(|pass| pass.stage).collect::<Vec<_>>())
    };
    assert!(!plan(&[]).contains("solid"));
    assert!(plan(&["solver.pbf.iterations=2"]).contains("collide_solids"));
}
