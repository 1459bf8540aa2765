//! Water at rest is at rest at any spacing: a block between walls fills its space, whether it was particles or
//! sampled anew by the quality ladder.

use brooklet_fluid::Scene;
use brooklet_fluid::particles::{ParticleSet, resample, sample_lattice};
use brooklet_study::Setup;
use brooklet_study::backend::{Options, run};
use brooklet_tests::gpu_of_long_run;

/// Spacings of which 10, and no whole number, fit between calm-pool's walls: rungs of the ladder among them.
const SPACINGS_M: [f64; 4] = [0.05, 0.0577, 0.0794, 0.047];
/// What the pool may reach, J, and sink by, m, particles and sampled anew: 1.5 times what is measured, .13 J and .7 mm,
/// .37 J and 1.9 mm (a lattice with gaps reaches 3.3 J and sinks by 23 mm). A lattice that fits sinks by what its own
/// weight compresses it by. One that was sampled anew keeps its volume by a last layer that is not whole, and spreads.
const EMITTED: [f64; 2] = [0.2, 1.1e-3];
const SAMPLED: [f64; 2] = [0.56, 2.9e-3];

fn pool(spacing_m: f64) -> Scene {
    Scene::load("calm-pool", &[format!("spacing_m={spacing_m}")]).unwrap()
}

/// The largest kinetic energy in a second, J, and how far the middle sinks, m.
fn unrest(scene: &Scene, particles: ParticleSet) -> (f64, f64) {
    let heights_m: f64 = particles.positions.iter().map(|p| f64::from(p.position_m[1])).sum();
    let first_m = heights_m / particles.positions.len() as f64;
    let sample_times_s = (1..=80).map(|k| f64::from(k) / 80.0).collect();
    let setup = Setup { scene: scene.clone(), particles, sample_times_s, relaxes: false, squeezed: false };
    let measured = run(&gpu_of_long_run(scene), &setup, &Options::default()).unwrap().measured;
    let most_j = measured.iter().map(|m| m.stats.kinetic_j).fold(0.0, f64::max);
    (most_j, first_m - measured.last().unwrap().stats.centre_of_mass_m[1])
}

fn check(what: &str, scene: &Scene, particles: ParticleSet, [limit_j, limit_m]: [f64; 2]) -> Result<(), String> {
    let count = particles.positions.len();
    let (most_j, sunk_m) = unrest(scene, particles);
    let said = format!(
        "{what} {} m: {count} particles, at most {most_j:.3} J, sinks by {:.2} mm",
        scene.spacing_m,
        1e3 * sunk_m
    );
    println!("{said}");
    if most_j < limit_j && sunk_m < limit_m { Ok(()) } else { Err(said) }
}

#[test]
fn a_pool_that_fits_no_spacing_is_calm() {
    for spacing_m in SPACINGS_M {
        let scene = pool(spacing_m);
        check("particles at", &scene, sample_lattice(&scene), EMITTED).unwrap();
    }
}

#[test]
fn a_pool_that_is_sampled_anew_is_calm() {
    let from = pool(0.05);
    let particles = sample_lattice(&from);
    for spacing_m in SPACINGS_M {
        let to = pool(spacing_m);
        let sampled = resample(&from, &particles, &to);
        check("sampled at", &to, sampled, SAMPLED).unwrap();
    }
}

/// The lattice of the spacing itself from the corner on leaves gaps at the other walls: it falls into them.
#[test]
fn a_lattice_with_gaps_fails() {
    let scene = pool(0.0577);
    let mut particles = sample_lattice(&scene);
    let spacing_m = scene.spacing_m as f32;
    let middle = particles
        .positions
        .iter()
        .map(|p| p.position_m)
        .fold([0.0f32; 3], |sum, at| std::array::from_fn(|a| sum[a].max(at[a])));
    // From wall to wall its steps are a ninth of the side: now those of the spacing, without the last layers.
    let layer = |position_m: [f32; 3], axis: usize| (position_m[axis] / middle[axis] * 8.5).floor();
    let keep: Vec<bool> =
        particles.positions.iter().map(|p| layer(p.position_m, 0) < 8.0 && layer(p.position_m, 2) < 8.0).collect();
    for position in &mut particles.positions {
        let at = position.position_m;
        position.position_m[0] = (layer(at, 0) + 0.5) * spacing_m;
        position.position_m[2] = (layer(at, 2) + 0.5) * spacing_m;
    }
    let mut kept = keep.iter();
    particles.positions.retain(|_| *kept.next().unwrap());
    let mut kept = keep.iter();
    particles.velocities.retain(|_| *kept.next().unwrap());
    for (id, position) in particles.positions.iter_mut().enumerate() {
        position.tag = id as u32;
    }
    assert_eq!(particles.positions.len(), 8 * 8 * 4);
    check("with gaps at", &scene, particles, SAMPLED).unwrap_err();
}
