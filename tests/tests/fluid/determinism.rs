//! `solver.deterministic`: runs repeat bit for bit, whatever the order of the input.

use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::{Scene, Session};
use brooklet_kernels::{Position, Velocity};
use brooklet_tests::{gpu_of_long_run, rng, small};
use rand::seq::SliceRandom;
use std::hash::{DefaultHasher, Hash, Hasher};

const SCENE: &str = "
spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [1.2, 0.8, 0.5]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.4, 0.6, 0.5] }
[solver.pbf]
iterations = 3
[forces]
xsph = 0.02
vorticity_m_s = 0.02
";

fn scene(deterministic: bool) -> Scene {
    Scene::from_toml(SCENE, "determinism.toml", &[format!("solver.deterministic={deterministic}")]).unwrap()
}

/// Every bit of the particles after `steps`, by id; from the scene's lattice as many times as large, in another order where
/// there is a seed for it.
fn particles_after(scene: &Scene, steps: u32, scale: f32, shuffled: Option<u64>) -> Vec<(Position, Velocity)> {
    let mut session = Session::new(&gpu_of_long_run(scene), scene).unwrap();
    let ParticleSet { positions, velocities } = session.read_particles().unwrap();
    let mut both: Vec<_> = positions.into_iter().zip(velocities).collect();
    for (position, _) in &mut both {
        position.position_m = position.position_m.map(|x| scale * x);
    }
    if let Some(seed) = shuffled {
        both.shuffle(&mut rng(seed));
    }
    let (positions, velocities): (Vec<_>, Vec<_>) = both.into_iter().unzip();
    session.write_particles(&ParticleSet { positions, velocities });
    for step in 0..steps {
        session.step().unwrap();
        // Keeps what has arrived from piling up.
        if step % 16 == 0 {
            session.stats();
        }
    }
    let ParticleSet { positions, velocities } = session.read_particles().unwrap();
    let mut both: Vec<_> = positions.into_iter().zip(velocities).collect();
    both.sort_by_key(|(position, _)| position.tag);
    both
}

fn hash_of(particles: &[(Position, Velocity)]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for (position, velocity) in particles {
        bytemuck::bytes_of(position).hash(&mut hasher);
        bytemuck::bytes_of(velocity).hash(&mut hasher);
    }
    hasher.finish()
}

#[test]
fn a_thousand_steps_repeat_bit_for_bit() {
    let scene = scene(true);
    let steps = if small() { 20 } else { 1000 };
    let first = particles_after(&scene, steps, 1.0, None);
    let again = particles_after(&scene, steps, 1.0, None);
    let shuffled = particles_after(&scene, steps, 1.0, Some(81));
    let hashes = [&first, &again, &shuffled].map(|particles| hash_of(particles));
    println!("{} particles, {steps} steps: {hashes:016x?}", first.len());
    assert_eq!(hashes[0], hashes[1], "a second run differs");
    assert_eq!(hashes[0], hashes[2], "another order of the input differs");
}

#[test]
fn without_it_another_order_of_the_input_shows() {
    // What the test above compares can differ: sums in another order round differently.
    let scene = scene(false);
    // So dense that cells hold several from the start: whoever is first there is summed first.
    let first = hash_of(&particles_after(&scene, 20, 0.6, None));
    assert!(
        (82..90).any(|seed| hash_of(&particles_after(&scene, 20, 0.6, Some(seed))) != first),
        "eight orders, one end"
    );
}
