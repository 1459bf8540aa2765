//! Scenes on the GPU against closed forms and conservation laws.

use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::{Scene, Session, Stats};
use brooklet_tests::{gpu, gpu_of_long_run};

fn scene(name: &str, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::load(name, &settings).unwrap()
}

/// Runs `steps` steps, measuring every `every` of them.
pub fn run(session: &mut Session, steps: u32, every: u32) -> Vec<Stats> {
    let mut history = Vec::new();
    for step in 1..=steps {
        session.step().unwrap();
        if step % every == 0 {
            session.measure().unwrap();
            history.extend(session.finish().unwrap().into_iter().filter_map(|frame| frame.stats));
        }
    }
    history
}

const FALL: &str = r#"
spacing_m = 0.05
[domain]
min_m = [0, -1, 0]
max_m = [1, 2, 1]
[[fluid]]
block = { min_m = [0.2, 1.2, 0.2], max_m = [0.25, 1.25, 0.25] }
velocity_m_s = [0.5, 1.0, -0.25]
"#;

/// Symplectic Euler's own closed form: v = v0 + n g dt, x = x0 + n v0 dt + g dt² n(n+1)/2.
#[test]
fn free_fall_of_one_and_two_particles_is_exact_to_rounding() {
    let pair = format!(
        "{FALL}[[fluid]]\nblock = {{ min_m = [0.25, 1.2, 0.2], max_m = [0.3, 1.25, 0.25] }}\nvelocity_m_s = [0.5, 1.0, -0.25]\n"
    );
    for (count, text) in [(1, FALL), (2, pair.as_str())] {
        let scene = Scene::from_toml(text, "fall.toml", &[]).unwrap();
        let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
        let start = session.read_particles().unwrap().positions;
        assert_eq!(start.len(), count);
        let steps = 100;
        run(&mut session, steps, 1000);
        let ParticleSet { positions, velocities } = session.read_particles().unwrap();
        let (n, dt_s) = (f64::from(steps), scene.solver.dt_s);
        let mut largest = 0.0_f64;
        for (position, velocity) in positions.iter().zip(&velocities) {
            let from = start.iter().find(|p| p.tag == position.tag).unwrap();
            for axis in 0..3 {
                let g = scene.gravity_m_s2[axis];
                let v0 = scene.fluids[0].velocity_m_s[axis];
                let v = v0 + n * g * dt_s;
                let x = f64::from(from.position_m[axis]) + n * v0 * dt_s + g * dt_s * dt_s * n * (n + 1.0) / 2.0;
                // Each step rounds a sum to half a unit in the last place: of x below 4 m, of v below 4 m/s;
                // the step's own constants (g, dt) are rounded once and act n times.
                let tolerance = n * 4.0 * 2.0_f64.powi(-24);
                let error = (f64::from(velocity.velocity_m_s[axis]) - v)
                    .abs()
                    .max((f64::from(position.position_m[axis]) - x).abs());
                largest = largest.max(error);
                assert!(error <= tolerance, "{count} particles, axis {axis}: off by {error:e}, allowed {tolerance:e}");
            }
        }
        println!("free fall of {count}: {steps} steps, largest difference {largest:e}");
    }
}

#[test]
fn momentum_in_free_space_drifts_by_rounding_alone() {
    let scene = scene("colliding-drops", &["spacing_m=0.03"]);
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    let history = run(&mut session, 120, 10);
    let last = history.last().unwrap();
    let mass_kg = scene.particle_mass_kg() * f64::from(last.particles);
    // Against the momentum that meets: half the mass at 1 m/s.
    let drift = last.momentum_kg_m_s.iter().map(|p| p.abs()).fold(0.0, f64::max) / (0.5 * mass_kg);
    println!("momentum drift over 120 steps: {drift:e} of what meets");
    let energy_left = last.kinetic_j / (0.5 * mass_kg);
    assert!(energy_left < 0.9, "the drops never met: {energy_left} of their energy is left");
    // Corrections are antisymmetric but rounded at each particle's own position (half a unit of 1 m),
    // four a step, divided by dt: a random walk of 480 roundings over some thousand particles.
    assert!(drift < 2.0e-4, "momentum drifts by {drift:e}");
    assert_eq!(last.quarantined + last.escaped, 0);
}

#[test]
fn energy_never_rises_and_water_comes_to_rest() {
    let scene = scene("dam-break", &["spacing_m=0.04"]);
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    session.measure().unwrap();
    session.finish().unwrap();
    let start = session.stats().unwrap();
    let mut before = start.kinetic_j + start.potential_j;
    let begin = before;
    let mut rise = 0.0_f64;
    let history = run(&mut session, 1200, 20);
    for stats in &history {
        let energy = stats.kinetic_j + stats.potential_j;
        rise = rise.max(energy - before);
        before = energy;
        assert_eq!(stats.particles, start.particles, "a particle was lost");
        assert_eq!(stats.quarantined, 0);
    }
    let last = history.last().unwrap();
    let filled_m = 0.5 * start.particles as f64 * scene.spacing_m.powi(3) / (1.6 * 0.6);
    println!(
        "dam break, 5 s: largest rise of energy {:.2e} of the start's; at the end centre of mass {:?} m (filled: {filled_m:.4}), kinetic {:.2e} J, compression mean {:.4} p99 {:.4} max {:.4}",
        rise / begin,
        last.centre_of_mass_m,
        last.kinetic_j,
        last.compression.mean,
        last.compression.p99,
        last.compression.max
    );
    assert!(rise / begin < 2.0e-3, "energy rises by {:e} of the start's", rise / begin);
    // The first sloshing mode of this tank has a period of 2.1 s and dies slowly, as in water: of the
    // 0.5 m that the column stood off the middle at the start, a fifth may be left.
    assert!((last.centre_of_mass_m[0] - 0.8).abs() < 0.1, "still leaning: {:?}", last.centre_of_mass_m);
    assert!(
        (last.centre_of_mass_m[1] / filled_m - 1.0).abs() < 0.08,
        "lost or gained volume: {:?}",
        last.centre_of_mass_m
    );
    assert!(last.kinetic_j < 0.01 * begin, "still moving: {} J", last.kinetic_j);
    let worst = history.iter().map(|s| s.compression.p99).fold(0.0, f64::max);
    println!("dam break: compression p99 reached {worst:.4}");
    assert!(worst < 0.036, "compression p99 reached {worst}");
}

#[test]
fn a_calm_pool_stays_calm() {
    let scene = scene("calm-pool", &[]);
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    let history = run(&mut session, 480, 40);
    let last = history.last().unwrap();
    println!("calm pool after 2 s: {last:?}");
    // It settles once by about half a spacing, for its surface layer has half the neighbours it
    // would need to be at rest on the lattice; that motion dies down and nothing stirs it again.
    let still = last.kinetic_j / last.potential_j;
    assert!(still < 5.0e-4, "kinetic energy is {still:e} of the potential energy");
    assert!(last.max_speed_m_s < 0.2, "moves at {} m/s", last.max_speed_m_s);
    let sunk_m = 0.125 - last.centre_of_mass_m[1];
    assert!((0.0..0.35 * scene.spacing_m).contains(&sunk_m), "its middle sinks by {sunk_m} m");
}

#[test]
fn a_particle_that_is_not_finite_is_quarantined_and_spreads_nothing() {
    let scene = scene("calm-pool", &["spacing_m=0.05"]);
    let mut session = Session::new(&gpu(), &scene).unwrap();
    let mut particles = session.read_particles().unwrap();
    let (positions, velocities) = (&mut particles.positions, &mut particles.velocities);
    positions[100].position_m[1] = f32::NAN;
    velocities[7].velocity_m_s[0] = f32::INFINITY;
    let gone = [positions[100].tag, positions[7].tag];
    session.write_particles(&particles);
    let history = run(&mut session, 30, 30);
    assert_eq!(history[0].quarantined, 2);
    assert_eq!(history[0].particles as usize, particles.positions.len() - 2);
    let ParticleSet { positions, velocities } = session.read_particles().unwrap();
    for (position, velocity) in positions.iter().zip(&velocities) {
        assert!(position.position_m.iter().chain(&velocity.velocity_m_s).all(|x| x.is_finite()));
        let quarantined = position.tag >> 31 == 1;
        assert_eq!(quarantined, gone.contains(&(position.tag & 0x7fff_ffff)));
    }
}
