//! Case 1: no particle, one, two. No dispatch faults, free fall is exact, and they come to rest.

use brooklet_tests::compare::ROUNDING;
use brooklet_tests::extreme::Case;

const TALL: &str = "
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [0.2, 1.0, 0.2]
[solver]
substeps = 2
[outputs]
measure_every_steps = 1
";

fn falling(count: usize) -> String {
    let block =
        |x: f64| format!("[[fluid]]\nblock = {{ min_m = [{x}, 0.9, 0.1], max_m = [{}, 0.92, 0.12] }}\n", x + 0.02);
    // Side by side, well inside each other's support.
    (0..count).map(|i| block(0.08 + 0.02 * i as f64)).fold(TALL.to_owned(), |text, fluid| text + &fluid)
}

#[test]
fn no_particle_runs_and_measures() {
    let mut case = Case::new(TALL, &[]);
    assert_eq!(case.count(), 0);
    let stats = case.recovers(0.1);
    assert_eq!((stats.particles, stats.quarantined, stats.kinetic_j), (0, 0, 0.0));
}

#[test]
fn one_and_two_particles_fall_exactly_and_come_to_rest() {
    for count in [1, 2] {
        let mut case = Case::new(&falling(count), &[]);
        assert_eq!(case.count(), count);
        let start = case.state();
        let (steps, substeps) = (80, 160.0);
        case.run(steps);
        let dt_s = case.scene().substep_s();
        let state = case.state();
        let mut largest = 0.0_f64;
        for i in 0..count {
            for axis in 0..3 {
                // Symplectic Euler's closed form: v = n g dt, x = x0 + g dt^2 n (n + 1) / 2.
                let g = case.scene().gravity_m_s2[axis];
                let v = substeps * g * dt_s;
                let x = f64::from(start.positions[i][axis]) + g * dt_s * dt_s * substeps * (substeps + 1.0) / 2.0;
                let error = (f64::from(state.velocities[i][axis]) - v)
                    .abs()
                    .max((f64::from(state.positions[i][axis]) - x).abs());
                largest = largest.max(error);
                // Each substep rounds sums below 4 once; the constants g and dt, rounded once, act n times.
                assert!(error <= substeps * 4.0 * ROUNDING, "{count} particles, axis {axis}: off by {error:e}");
            }
        }
        println!("case 1: {count} particles, {substeps} substeps: largest difference {largest:.1e}");
        let stats = case.recovers(1.0);
        assert_eq!(stats.particles as usize, count);
        assert!(stats.max_speed_m_s < 1.0e-3, "on the floor at {} m/s", stats.max_speed_m_s);
        assert!(case.state().positions.iter().all(|p| p[1] < 0.02), "not on the floor");
    }
}
