//! The same fluid at another spacing: what is kept, and how well.

use brooklet_fluid::Scene;
use brooklet_fluid::particles::{ParticleSet, resample, sample_lattice};
use brooklet_kernels::{FLUID_SHIFT, QUARANTINED};
use brooklet_tests::compare::vector;
use glam::DVec3;

const D_M: f64 = 0.02;

fn scene(fluid: &str, settings: &[&str]) -> Scene {
    let text =
        format!("spacing_m = {D_M}\n[domain]\nmin_m = [-0.5, 0, -0.5]\nmax_m = [0.5, 1, 0.5]\n[[fluid]]\n{fluid}");
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(&text, "test", &settings).unwrap()
}

/// The scene at another spacing, as a ladder changes it.
fn at(scene: &Scene, ratio: f64) -> Scene {
    Scene { spacing_m: ratio * scene.spacing_m, ..scene.clone() }
}

/// A rotating, streaming velocity: v = v0 + w x (x - c).
fn swirl(place_m: DVec3) -> DVec3 {
    DVec3::new(0.5, -0.2, 0.1) + DVec3::new(0.0, 3.0, 1.0).cross(place_m - DVec3::new(0.5, 0.5, 0.5))
}

/// As the scene's dimensions allow it.
fn moving(scene: &Scene, place_m: DVec3) -> DVec3 {
    swirl(place_m) * if scene.domain.is_flat() { DVec3::new(1.0, 1.0, 0.0) } else { DVec3::ONE }
}

fn stirred(scene: &Scene) -> ParticleSet {
    let mut particles = sample_lattice(scene);
    for (position, velocity) in particles.positions.iter().zip(&mut particles.velocities) {
        velocity.velocity_m_s = moving(scene, vector(position.position_m)).as_vec3().to_array();
    }
    particles
}

/// What a particle takes.
fn cell(scene: &Scene) -> f64 {
    scene.fitted_spacing_m().powi(scene.domain.dimensions as i32)
}

/// Volume (area in two dimensions), centre of mass, and momentum over density.
fn totals(scene: &Scene, particles: &ParticleSet) -> (f64, DVec3, DVec3) {
    let cell = cell(scene);
    let count = particles.positions.len() as f64;
    let centre_m: DVec3 = particles.positions.iter().map(|p| vector(p.position_m)).sum();
    let momentum: DVec3 = particles.velocities.iter().map(|v| vector(v.velocity_m_s)).sum();
    (count * cell, centre_m / count, momentum * cell)
}

/// How much is lost: volume and momentum relative, the centre in spacings of the coarser lattice, and the
/// mean error of the velocities over the mean speed. Most of the velocities' error is the test's own: walls
/// mirror, and the swirl goes into them. Most of the centre's is the sheet's, which lies where the new
/// lattice has no layer.
fn check(scene: &Scene, before: &ParticleSet, to: &Scene, after: &ParticleSet) -> Result<(), String> {
    let (volume, centre_m, momentum) = totals(scene, before);
    let (new_volume, new_centre_m, new_momentum) = totals(to, after);
    let (mut off, mut speed) = (0.0, 0.0);
    for (position, velocity) in after.positions.iter().zip(&after.velocities) {
        let expected = moving(scene, vector(position.position_m));
        off += (vector(velocity.velocity_m_s) - expected).length();
        speed += expected.length();
    }
    let losses = [
        // To half a particle.
        ("volume", (new_volume / volume - 1.0).abs(), 0.5001 * cell(to) / volume),
        ("momentum", (new_momentum - momentum).length() / momentum.length(), 0.035),
        ("centre", (new_centre_m - centre_m).length() / scene.spacing_m.max(to.spacing_m), 0.3),
        ("velocities", off / speed, 0.035),
    ];
    let counts = [before, after].map(|particles| particles.positions.len());
    println!("{counts:?} at {:.2}: {losses:.4?}", to.spacing_m / scene.spacing_m);
    match losses.iter().find(|(_, loss, allowed)| loss > allowed) {
        None => Ok(()),
        Some((what, loss, allowed)) => Err(format!("{what}: {loss} is lost, {allowed} is allowed")),
    }
}

const BLOCK: &str = "block = { min_m = [-0.5, 0, -0.5], max_m = [0, 0.5, 0.5] }";
const BALL: &str = "sphere = { centre_m = [0.1, 0.6, 0.05], radius_m = 0.2 }";
/// Two layers in the air.
const SHEET: &str = "block = { min_m = [-0.4, 0.53, -0.4], max_m = [0.4, 0.57, 0.4] }";
const RATIOS: [f64; 5] = [0.7, 0.85, 1.0, 1.25, 1.6];

#[test]
fn volume_momentum_and_place_are_kept() {
    for fluid in [BLOCK, BALL, SHEET] {
        for dimensions in ["domain.dimensions=3", "domain.dimensions=2"] {
            println!("{fluid}, {dimensions}");
            let scene = scene(fluid, &[dimensions]);
            let before = stirred(&scene);
            for ratio in RATIOS {
                let to = at(&scene, ratio);
                check(&scene, &before, &to, &resample(&scene, &before, &to)).unwrap();
            }
        }
    }
}

#[test]
fn a_fluid_that_lost_something_fails() {
    let scene = scene(BLOCK, &[]);
    let to = at(&scene, 1.25);
    let before = stirred(&scene);
    let right = resample(&scene, &before, &to);
    check(&scene, &before, &to, &right).unwrap();
    let kept = right.positions.len() * 99 / 100;
    let mut fewer = right.clone();
    fewer.positions.truncate(kept);
    fewer.velocities.truncate(kept);
    let mut slower = right.clone();
    slower.velocities.iter_mut().for_each(|v| v.velocity_m_s[1] *= 0.9);
    let mut aside = right.clone();
    aside.positions.iter_mut().for_each(|p| p.position_m[0] += 0.01);
    for (wrong, what) in [(fewer, "volume"), (slower, "momentum"), (aside, "centre")] {
        let error = check(&scene, &before, &to, &wrong).unwrap_err();
        assert!(error.starts_with(what), "{error}");
    }
}

#[test]
fn a_lattice_at_rest_stays_where_it_is_and_at_rest() {
    let scene = scene(BLOCK, &[]);
    let before = sample_lattice(&scene);
    let after = resample(&scene, &before, &scene);
    assert_eq!(after.positions.len(), before.positions.len());
    for (one, other) in before.positions.iter().zip(&after.positions) {
        assert_eq!(one.tag, other.tag);
        assert!((vector(one.position_m) - vector(other.position_m)).length() < 1e-6);
    }
    assert!(after.velocities.iter().all(|v| v.velocity_m_s == [0.0; 3]));
}

#[test]
fn whose_fluid_it_is_and_which_order_they_come_in() {
    let two = format!("{BLOCK}\n[[fluid]]\nsphere = {{ centre_m = [0.25, 0.75, 0.05], radius_m = 0.2 }}");
    let scene = scene(&two, &[]);
    let mut before = sample_lattice(&scene);
    let to = at(&scene, 1.25);
    let fluid_of = |tag: u32| tag >> FLUID_SHIFT & 127;
    let after = resample(&scene, &before, &to);
    for (id, position) in after.positions.iter().enumerate() {
        assert_eq!(position.tag & ((1 << FLUID_SHIFT) - 1), id as u32);
        // The ball hangs beside the block.
        assert_eq!(fluid_of(position.tag), u32::from(position.position_m[0] > 0.525));
    }
    // What is quarantined, or has no finite place, is nowhere; of the others the order does not matter.
    let whole = after.positions.len();
    let number = before.positions.len();
    for i in 0..number / 2 {
        before.positions.swap(i, number - 1 - i);
        before.velocities.swap(i, number - 1 - i);
    }
    let swapped = resample(&scene, &before, &to);
    assert!(swapped.positions.iter().zip(&after.positions).all(|(a, b)| a.position_m == b.position_m));
    for i in 0..number / 4 {
        before.positions[i].tag |= QUARANTINED;
        before.positions[number / 2 + i].position_m[1] = f32::NAN;
    }
    let half = resample(&scene, &before, &to).positions.len();
    assert!((half as f64 / whole as f64 - 0.5).abs() < 0.01, "{half} of {whole}");
    assert!(resample(&scene, &ParticleSet::default(), &to).positions.is_empty());
}

#[test]
fn a_tank_is_filled_to_its_walls_and_across_its_seams() {
    // Both axes fit 4 h of both spacings: 0.96 m is 6 x 0.16 m and 5 x 0.192 m.
    let fluid = "block = { min_m = [0, 0, 0], max_m = [0.96, 0.48, 0.96] }";
    let sides = ["domain.min_m=[0,0,0]", "domain.max_m=[0.96,0.96,0.96]"];
    for periodic in ["domain.periodic=[true,false,true]", "domain.periodic=[false,false,false]"] {
        let scene = scene(fluid, &[sides[0], sides[1], periodic]);
        let to = at(&scene, 1.2);
        let after = resample(&scene, &sample_lattice(&scene), &to);
        assert_eq!(after.positions.len(), 40 * 20 * 40);
        let layers: std::collections::BTreeSet<u32> =
            after.positions.iter().map(|p| (p.position_m[1] / 0.024) as u32).collect();
        assert_eq!(layers, (0..20).collect(), "nothing above the surface, and no hole at a wall");
    }
}
