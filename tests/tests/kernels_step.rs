//! A whole step of the chain, as the fluid records it, against the f64 twin's.

use brooklet_fluid::{Scene, Simulation};
use brooklet_kernels::{Position, Velocity};
use brooklet_reference::params::{Smoothing, Step};
use brooklet_reference::particles::predict::Particle;
use brooklet_reference::shared::lattice;
use brooklet_reference::step::Fluid;
use brooklet_tests::cases::{pbf_of, walls_of};
use brooklet_tests::compare::{Worst, vector};
use brooklet_tests::harness::small;
use brooklet_tests::{gpu, rng};
use glam::DVec3;
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
iterations = 4
s_corr_k = 0.001
xsph = 0.05
vorticity_m_s = 0.01
";

/// The scene's particles moved a little off their lattice, so that nothing is even by symmetry.
fn start(simulation: &mut Simulation) -> (Vec<Position>, Vec<Velocity>) {
    let (mut positions, mut velocities) = simulation.particles().unwrap();
    let mut rng = rng(71);
    let mut part = |size: f32| (rng.random::<f32>() - 0.5) * size;
    for (position, velocity) in positions.iter_mut().zip(&mut velocities) {
        for axis in 0..3 {
            // The lattice starts half a spacing inside, so all stay inside.
            position.position_m[axis] += part(0.006);
            velocity.velocity_m_s[axis] += part(0.4);
        }
    }
    simulation.set_particles(&positions, &velocities);
    (positions, velocities)
}

fn twin(scene: &Scene, positions: &[Position], velocities: &[Velocity]) -> Fluid {
    let size_m = DVec3::from_array(scene.domain.size_m());
    let walls = scene.domain.walls;
    Fluid {
        particles: positions
            .iter()
            .zip(velocities)
            .map(|(position, velocity)| Particle {
                position_m: vector(position.position_m),
                velocity_m_s: vector(velocity.velocity_m_s),
                quarantined: false,
            })
            .collect(),
        step: Step {
            gravity_m_s2: DVec3::from_array(scene.gravity_m_s2),
            dt_s: scene.substep_s(),
            domain_size_m: size_m,
            walls,
            wall_offset_m: scene.spacing_m / 2.0,
            max_speed_m_s: scene.max_speed_m_s(),
        },
        smoothing: Smoothing { support_m: scene.support_m(), weight: lattice::weight(scene.solver.support_ratio) },
        pbf: pbf_of(&brooklet_fluid::solver::pbf::params(scene)),
        iterations: scene.solver.iterations,
        walls: walls.then_some(walls_of(&brooklet_fluid::kernel::params(scene), size_m)),
        grid_ends_at_domain: true,
    }
}

fn scene_with(settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(SCENE, "step.toml", &settings).unwrap()
}

/// Follows `scene` on the GPU and `twin_scene` with the twin, and compares where they end.
fn follow(scene: &Scene, twin_scene: &Scene, steps: usize, worst: &mut Worst) -> Result<(), String> {
    let mut simulation = Simulation::new(&gpu(), scene).unwrap();
    let (positions, velocities) = start(&mut simulation);
    assert_eq!(positions.len(), 8 * 10 * 6);
    let mut fluid = twin(twin_scene, &positions, &velocities);
    for _ in 0..steps {
        simulation.step().unwrap();
        for _ in 0..scene.solver.substeps {
            fluid.substep();
        }
    }
    let (after, velocities) = simulation.particles().unwrap();
    let mut furthest = 0.0_f64;
    for (position, velocity) in after.iter().zip(&velocities) {
        let id = (position.tag & 0xff_ffff) as usize;
        let expected = fluid.particles[id];
        furthest = furthest.max((expected.position_m - vector(positions[id].position_m)).length());
        worst.check3(position.position_m, expected.position_m, scene.spacing_m)?;
        let speed = scene.spacing_m / scene.substep_s();
        worst.check3(velocity.velocity_m_s, expected.velocity_m_s, speed)?;
    }
    assert!(furthest > 0.1 * scene.spacing_m, "the fluid hardly moved: {furthest} m");
    Ok(())
}

fn matches(settings: &[&str], steps: usize, tolerance: f64, name: &'static str) {
    let scene = scene_with(settings);
    let mut worst = Worst::new(name, tolerance);
    follow(&scene, &scene, steps, &mut worst).unwrap();
    worst.report();
}

// Differences in spacings. A position of up to 15 spacings rounds by 1e-6 of one in each of the
// substep's eight iterations, whose corrections multiply it by a few.

#[test]
fn a_step_matches_its_twin() {
    matches(&[], 1, 1e-4, "step");
}

#[test]
fn a_step_without_its_optional_terms_matches_its_twin() {
    let off = ["solver.s_corr_k=0", "solver.xsph=0", "solver.vorticity_m_s=0"];
    matches(&off, 1, 1e-4, "step without optional terms");
}

#[test]
fn a_step_in_an_open_domain_matches_its_twin() {
    matches(&["domain.walls=false", "solver.iterations=1"], 1, 1e-4, "step without walls");
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
        "solver.s_corr_k=0",
        "solver.xsph=0",
        "solver.vorticity_m_s=0",
        "solver.iterations=3",
        "solver.relaxation=0.501",
        "solver.cfm=0.2",
        "domain.walls=false",
    ];
    for setting in wrong {
        let mut worst = Worst::new("step", 1e-4);
        let twin_scene = scene_with(&[setting]);
        assert_ne!(twin_scene, scene, "{setting} changes nothing");
        assert!(follow(&scene, &twin_scene, 1, &mut worst).is_err(), "a twin with {setting} was not told apart");
    }
}

#[test]
fn a_scene_without_particles_runs() {
    let mut scene = scene_with(&[]);
    scene.fluids.clear();
    scene.outputs.measure_every_steps = 1;
    let mut simulation = Simulation::new(&gpu(), &scene).unwrap();
    simulation.step().unwrap();
    simulation.measure().unwrap();
    let stats = simulation.finish().unwrap().expect("a measurement was asked for");
    assert_eq!((stats.particles, stats.quarantined, stats.escaped), (0, 0, 0));
    assert_eq!((stats.density_error.max, stats.max_speed_m_s, stats.kinetic_j), (0.0, 0.0, 0.0));
    assert!(simulation.particles().unwrap().0.is_empty());
}
