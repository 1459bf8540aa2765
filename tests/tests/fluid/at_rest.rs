//! Water at rest is at rest at any spacing: a block between walls fills its space, whether it was emitted or
//! sampled anew by the quality ladder.

use brooklet_fluid::particles::{Emitted, emit, resample};
use brooklet_fluid::{Scene, Simulation};
use brooklet_tests::gpu;

fn pool(spacing_m: f64) -> Scene {
    let settings = [format!("spacing_m={spacing_m}"), "outputs.measure_every_steps=1".into()];
    Scene::load("calm-pool", &settings).unwrap()
}

/// The largest kinetic energy in a second, J, and how far the middle sank, m.
fn unrest(scene: &Scene, start: &Emitted) -> (f64, f64) {
    let mut simulation = Simulation::new(&gpu(), scene).unwrap();
    simulation.set_particles(&start.positions, &start.velocities);
    let (mut most_j, mut heights_m) = (0.0_f64, Vec::new());
    for _ in 0..240 {
        simulation.step().unwrap();
        if let Some(stats) = simulation.finish().unwrap() {
            most_j = most_j.max(stats.kinetic_j);
            heights_m.push(stats.centre_of_mass_m[1]);
        }
    }
    let first_m: f64 = start.positions.iter().map(|p| f64::from(p.position_m[1])).sum::<f64>() / start.positions.len() as f64;
    (most_j, first_m - heights_m.last().unwrap())
}

#[test]
fn a_pool_that_fits_no_spacing_is_as_calm_as_one_that_does() {
    for spacing_m in [0.05, 0.0577, 0.063, 0.0721, 0.047, 0.0333] {
        let scene = pool(spacing_m);
        let start = emit(&scene);
        let (most_j, sunk_m) = unrest(&scene, &start);
        println!("emitted at {spacing_m}: {} particles, at most {most_j:.3} J, sinks {:.2} mm", start.positions.len(), 1e3 * sunk_m);
    }
}

#[test]
fn a_pool_that_is_sampled_anew_is_calm() {
    let from = pool(0.05);
    let particles = emit(&from);
    for spacing_m in [0.05, 0.0577, 0.063, 0.0721, 0.0411] {
        let to = pool(spacing_m);
        let start = resample(&from, &particles, &to);
        let (most_j, sunk_m) = unrest(&to, &start);
        println!("sampled at {spacing_m}: {} particles, at most {most_j:.3} J, sinks {:.2} mm", start.positions.len(), 1e3 * sunk_m);
    }
}
