//! A whole step of the chain, as the fluid records it, against the f64 twin's.

use brooklet_check::Wrong;
use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::{ParticleSource, Scene, Session, SessionRecorder};
use brooklet_kernels::{Position, Velocity};
use brooklet_reference::params::nearest_image;
use brooklet_tests::compare::{Worst, vector};
use brooklet_tests::small;
use brooklet_tests::{gpu, rng, twin::twin};
use rand::RngExt;

const SCENE: &str = "
spacing_m = 0.02
[domain]
min_m = [-1.0, 2.0, 5.0]
max_m = [-0.7, 2.3, 5.2]
[[fluid]]
block = { min_m = [-1.0, 2.0, 5.0], max_m = [-0.84, 2.2, 5.12] }
[solver]
dt_s = 0.005
substeps = 2
[solver.pbf]
iterations = 4
acceleration = \"none\"
s_corr_k = 0.001
[forces]
xsph = 0.05
vorticity_m_s = 0.01
";

/// Water in a channel that repeats itself along x and z, moving across its seams.
const CHANNEL: &str = "
spacing_m = 0.02
[domain]
min_m = [-1.0, 2.0, 5.0]
max_m = [-0.68, 2.3, 5.16]
periodic = [true, false, true]
[[fluid]]
block = { min_m = [-1.0, 2.0, 5.0], max_m = [-0.68, 2.2, 5.16] }
velocity_m_s = [0.8, 0.0, -0.6]
[solver]
dt_s = 0.005
substeps = 2
[solver.pbf]
iterations = 4
acceleration = \"none\"
s_corr_k = 0.001
[forces]
xsph = 0.05
vorticity_m_s = 0.01
";

/// A column of water in a tank of two dimensions.
const FLAT: &str = "
spacing_m = 0.02
[domain]
min_m = [-1.0, 2.0, 5.0]
max_m = [-0.2, 2.6, 5.02]
dimensions = 2
[[fluid]]
block = { min_m = [-1.0, 2.0, 5.0], max_m = [-0.6, 2.4, 5.02] }
[solver]
dt_s = 0.005
substeps = 2
[solver.pbf]
iterations = 4
acceleration = \"none\"
s_corr_k = 0.001
[forces]
xsph = 0.05
vorticity_m_s = 0.01
";

/// The scene's particles moved a little off their lattice, so that nothing is even by symmetry.
fn start(session: &mut Session) -> (Vec<Position>, Vec<Velocity>) {
    let ParticleSet { mut positions, mut velocities } = session.read_particles().unwrap();
    let mut rng = rng(71);
    let dimensions = session.scene().domain.dimensions as usize;
    let mut part = |size: f32| (rng.random::<f32>() - 0.5) * size;
    for (position, velocity) in positions.iter_mut().zip(&mut velocities) {
        for axis in 0..dimensions {
            // The lattice starts half a spacing inside, so all stay inside.
            position.position_m[axis] += part(0.006);
            velocity.velocity_m_s[axis] += part(0.4);
        }
    }
    let particles = ParticleSet { positions, velocities };
    session.write_particles(&particles);
    (particles.positions, particles.velocities)
}

fn scene_with(settings: &[&str]) -> Scene {
    scene_of(SCENE, settings)
}

fn scene_of(text: &str, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(text, "step.toml", &settings).unwrap()
}

/// Follows `scene` on the GPU and `twin_scene` with the twin, and compares where they end.
fn follow(scene: &Scene, twin_scene: &Scene, steps: usize, worst: &mut Worst) -> Result<(), Wrong> {
    let mut session = Session::new(&gpu(), scene).unwrap();
    let (positions, velocities) = start(&mut session);
    assert!(positions.len() >= 400);
    let mut fluid = twin(twin_scene, &positions, &velocities);
    for _ in 0..steps {
        session.step().unwrap();
        for _ in 0..scene.solver.substeps {
            fluid.substep();
        }
    }
    let ParticleSet { positions: after, velocities } = session.read_particles().unwrap();
    let mut furthest = 0.0_f64;
    for (position, velocity) in after.iter().zip(&velocities) {
        let id = (position.tag & 0xff_ffff) as usize;
        let expected = fluid.particles[id];
        furthest = furthest.max((expected.position_m - vector(positions[id].position_m)).length());
        let got_m = vector(position.position_m);
        // On which side of a seam it is, rounding may decide.
        let image_m = got_m + nearest_image(expected.position_m - got_m, fluid.step.period_m);
        worst.check3(position.position_m, image_m, scene.spacing_m)?;
        let speed = scene.spacing_m / scene.substep_s();
        worst.check3(velocity.velocity_m_s, expected.velocity_m_s, speed)?;
    }
    assert!(furthest > 0.1 * scene.spacing_m, "the fluid hardly moved: {furthest} m");
    Ok(())
}

fn matches(settings: &[&str], steps: usize, tolerance: f64, name: &'static str) {
    matches_scene(scene_with(settings), steps, tolerance, name);
}

fn matches_scene(scene: Scene, steps: usize, tolerance: f64, name: &'static str) {
    let device = &brooklet_tests::device();
    let mut worst = Worst::new(name, tolerance);
    follow(&scene, &scene, steps, &mut worst).unwrap();
    worst.report(device);
}

// Differences in spacings. A position of up to 15 spacings rounds by 1e-6 of one in each of the
// substep's eight iterations, whose corrections multiply it by a few.

#[test]
fn a_step_matches_its_twin() {
    matches(&[], 1, 1e-4, "step");
}

#[test]
fn a_step_without_its_optional_terms_matches_its_twin() {
    let off = ["solver.pbf.s_corr_k=0", "forces.xsph=0", "forces.vorticity_m_s=0"];
    matches(&off, 1, 1e-4, "step without optional terms");
}

#[test]
fn an_accelerated_step_matches_its_twin() {
    let chebyshev = "solver.pbf.acceleration=chebyshev";
    matches(&[chebyshev], 1, 1e-4, "step with momentum");
    matches(&[chebyshev, "solver.pbf.iterations=8"], 1, 1e-4, "step with accumulated momentum");
    // A lambda is rounded to f16, and twice as much of it is left to the next iteration.
    let packed = [chebyshev, "solver.pbf.iterations=8", "solver.precision=relaxed"];
    matches(&packed, 1, 4e-3, "packed step with accumulated momentum");
    // One without, of plain Jacobi where nothing is compressed much, or of other weights is told apart.
    let scene = scene_with(&[chebyshev, "solver.pbf.iterations=8"]);
    for wrong in ["solver.pbf.acceleration=none", "solver.pbf.iterations=7", "solver.pbf.cfm=0.02"] {
        let mut worst = Worst::new("step with accumulated momentum", 1e-4);
        let twin_scene = scene.with_setting(wrong).unwrap();
        assert!(follow(&scene, &twin_scene, 1, &mut worst).is_err(), "a twin with {wrong} was not told apart");
    }
}

#[test]
fn a_step_with_a_coarse_correction_matches_its_twin() {
    let on = ["solver.pbf.acceleration=chebyshev", "solver.pbf.coarse_correction=true"];
    matches(&on, 1, 1e-4, "step with coarse correction");
    matches(&[&on[..], &["domain.walls=false"]].concat(), 1, 1e-4, "open step with coarse correction");
    matches(&[&on[..], &["solver.precision=relaxed"]].concat(), 1, 4e-3, "packed step with coarse correction");
    matches_scene(scene_of(CHANNEL, &on), 1, 1e-4, "step across seams with coarse correction");
    matches_scene(scene_of(FLAT, &on), 1, 1e-4, "step in two dimensions with coarse correction");
    let scene = scene_with(&on);
    let mut worst = Worst::new("step with coarse correction", 1e-4);
    let twin_scene = scene.with_setting("solver.pbf.coarse_correction=false").unwrap();
    assert!(follow(&scene, &twin_scene, 1, &mut worst).is_err(), "a twin without it was not told apart");
}

#[test]
fn a_warm_step_matches_its_twin() {
    // The second of two substeps begins with what the first one kept.
    let on = ["solver.pbf.acceleration=chebyshev", "solver.pbf.coarse_correction=false", "solver.pbf.warm_start=0.3"];
    let coarse = [&on[..], &["solver.pbf.coarse_correction=true"]].concat();
    matches(&on, 1, 1e-4, "warm step");
    matches(&[&on[..], &["solver.precision=relaxed"]].concat(), 1, 4e-3, "packed warm step");
    // A total is f16 while the coarse multiplier is not added.
    matches(&coarse, 1, 1e-3, "warm step with coarse correction");
    matches(&[&coarse[..], &["solver.precision=relaxed"]].concat(), 1, 4e-3, "packed warm step with coarse correction");
    matches_scene(scene_of(CHANNEL, &on), 1, 1e-4, "warm step across seams");
    matches_scene(scene_of(FLAT, &on), 1, 1e-4, "warm step in two dimensions");
    let scene = scene_with(&on);
    for wrong in ["solver.pbf.warm_start=0", "solver.pbf.warm_start=0.25"] {
        let mut worst = Worst::new("warm step", 1e-4);
        let twin_scene = scene.with_setting(wrong).unwrap();
        assert!(follow(&scene, &twin_scene, 1, &mut worst).is_err(), "a twin with {wrong} was not told apart");
    }
}

#[test]
fn a_step_in_an_open_domain_matches_its_twin() {
    matches(&["domain.walls=false", "solver.pbf.iterations=1"], 1, 1e-4, "step without walls");
}

#[test]
fn steps_across_seams_match_their_twin() {
    matches_scene(scene_of(CHANNEL, &[]), 1, 1e-4, "step across seams");
    // 0.2 m in ten steps: most of the particles change sides.
    if !small() {
        matches_scene(scene_of(CHANNEL, &["solver.dt_s=0.01"]), 10, 2e-2, "ten steps across seams");
    }
    // A twin that is not periodic, or has walls instead of a seam, is told apart.
    let scene = scene_of(CHANNEL, &[]);
    for wrong in ["domain.periodic=[true, false, false]", "domain.periodic=[false, false, true]", "domain.walls=false"]
    {
        let mut worst = Worst::new("step across seams", 1e-4);
        assert!(follow(&scene, &scene_of(CHANNEL, &[wrong]), 1, &mut worst).is_err(), "{wrong}");
    }
}

#[test]
fn steps_in_two_dimensions_match_their_twin() {
    matches_scene(scene_of(FLAT, &[]), 1, 1e-4, "step in two dimensions");
    if !small() {
        matches_scene(scene_of(FLAT, &[]), 10, 2e-2, "ten steps in two dimensions");
    }
    let box_of_two = ["domain.periodic=[true, true, false]", "domain.max_m=[-0.2, 2.64, 5.02]"];
    matches_scene(scene_of(FLAT, &box_of_two), 1, 1e-4, "step in two periodic dimensions");
    // A twin with the lattice sums and walls of three dimensions is told apart.
    let scene = scene_of(FLAT, &[]);
    for wrong in ["domain.dimensions=3", "domain.walls=false"] {
        let mut worst = Worst::new("step in two dimensions", 1e-4);
        assert!(follow(&scene, &scene_of(FLAT, &[wrong]), 1, &mut worst).is_err(), "{wrong}");
    }
}

#[test]
fn ten_steps_stay_near_their_twin() {
    // Before particles meet anew: differences grow, ten-fold in some ten steps once they do.
    if !small() {
        matches(&[], 10, 2e-2, "ten steps");
    }
}

#[test]
fn a_missing_or_wrong_term_is_seen() {
    let scene = scene_with(&[]);
    let wrong = [
        "solver.pbf.s_corr_k=0",
        "forces.xsph=0",
        "forces.vorticity_m_s=0",
        "solver.pbf.iterations=3",
        "solver.pbf.relaxation=0.501",
        "solver.pbf.cfm=0.2",
        "domain.walls=false",
    ];
    for setting in wrong {
        let mut worst = Worst::new("step", 1e-4);
        let twin_scene = scene_with(&[setting]);
        assert_ne!(twin_scene, scene, "{setting} changes nothing");
        assert!(follow(&scene, &twin_scene, 1, &mut worst).is_err(), "a twin with {setting} was not told apart");
    }
}

/// Relaxes the scene's particles for a number of rounds, moved off their lattice, on the GPU and as the twin of
/// `twin_scene` does, and compares where they end.
fn relax(scene: &Scene, twin_scene: &Scene, rounds: usize, worst: &mut Worst) -> Result<(), Wrong> {
    let planned = SessionRecorder::new(scene, ParticleSource::Scene).with_relaxation().sweep().unwrap();
    let mut session = Session::start(&gpu(), planned).unwrap();
    let (positions, velocities) = start(&mut session);
    let mut fluid = twin(twin_scene, &positions, &velocities);
    let relax = session.recorded().relaxation.relax.id();
    for _ in 0..rounds {
        session.engine_mut().run(&[relax], &[]).unwrap();
        fluid.relax();
    }
    let ParticleSet { positions: after, velocities: kept } = session.read_particles().unwrap();
    let mut furthest = 0.0_f64;
    for (position, velocity) in after.iter().zip(&kept) {
        let id = (position.tag & 0xff_ffff) as usize;
        assert_eq!(*velocity, velocities[id], "a round changes no velocity");
        let expected_m = fluid.particles[id].position_m;
        furthest = furthest.max((expected_m - vector(positions[id].position_m)).length());
        let got_m = vector(position.position_m);
        let image_m = got_m + nearest_image(expected_m - got_m, fluid.step.period_m);
        worst.check3(position.position_m, image_m, scene.spacing_m)?;
    }
    assert!(furthest > 0.02 * scene.spacing_m, "the fluid hardly moved: {furthest} m");
    Ok(())
}

#[test]
fn relaxation_matches_its_twin() {
    let chebyshev = "solver.pbf.acceleration=chebyshev";
    for (text, settings) in
        [(SCENE, &[][..]), (SCENE, &[chebyshev, "solver.pbf.iterations=8"]), (CHANNEL, &[]), (FLAT, &[])]
    {
        let mut worst = Worst::new("relaxation", 1e-4);
        let scene = scene_of(text, settings);
        relax(&scene, &scene, 2, &mut worst).unwrap();
        worst.report(&brooklet_tests::device());
    }
    let scene = scene_with(&[]);
    for wrong in ["solver.pbf.iterations=3", "solver.pbf.relaxation=0.52", "domain.walls=false"] {
        let mut worst = Worst::new("relaxation", 1e-4);
        assert!(relax(&scene, &scene_with(&[wrong]), 2, &mut worst).is_err(), "a twin with {wrong} was not told apart");
    }
}

#[test]
fn a_scene_without_particles_runs() {
    let mut scene = scene_with(&[]);
    scene.fluids.clear();
    scene.outputs.measure_every_steps = 1;
    let mut session = Session::new(&gpu(), &scene).unwrap();
    session.step().unwrap();
    session.measure().unwrap();
    session.finish().unwrap();
    let stats = session.stats().expect("a measurement was asked for");
    assert_eq!((stats.particles, stats.quarantined, stats.escaped), (0, 0, 0));
    assert_eq!((stats.density_error.max, stats.max_speed_m_s, stats.kinetic_j), (0.0, 0.0, 0.0));
    assert!(session.read_particles().unwrap().positions.is_empty());
}
