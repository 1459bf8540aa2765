//! Prints how fast the f64 twin of the whole chain is: `cargo run -p brooklet-tests --example twin_speed`.

use brooklet_fluid::{Scene, particles::sample_lattice};
use brooklet_tests::twin::twin;
use std::time::Instant;

fn main() {
    for (name, side, depth, domain) in [
        ("3-D, walls", 0.32, 0.32, ""),
        ("3-D, periodic", 0.32, 0.32, "periodic = [true, false, true]"),
        ("2-D, walls", 1.28, 0.02, "dimensions = 2"),
        ("2-D, periodic", 1.28, 0.02, "dimensions = 2\nperiodic = [true, true, false]"),
    ] {
        let text = format!(
            "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{side}, {side}, {depth}]\n{domain}\n\
             [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [{side}, {side}, {depth}] }}\n"
        );
        let scene = match Scene::from_toml(&text, "speed.toml", &[]) {
            Ok(scene) => scene,
            Err(error) => panic!("{error}"),
        };
        let emitted = sample_lattice(&scene);
        let mut fluid = twin(&scene, &emitted.positions, &emitted.velocities);
        let start = Instant::now();
        let steps = 20;
        for _ in 0..steps {
            fluid.substep();
        }
        let seconds = start.elapsed().as_secs_f64();
        let iterations = fluid.particles.len() * steps * scene.solver.pbf.iterations as usize;
        println!(
            "{name}: {} particles, {:.1} ms a step, {:.2} M particle iterations a second",
            fluid.particles.len(),
            1e3 * seconds / steps as f64,
            1e-6 * iterations as f64 / seconds
        );
    }
}
