//! Case 7: the same scene a thousand times smaller and larger gives the same result in its own
//! units: lengths and gravity scaled alike, time not.

use brooklet_fluid::Stats;
use brooklet_tests::extreme::{Case, State};

fn dam(spacing_m: f64, counts: [u32; 3]) -> String {
    let [x, y, z] = counts.map(|n| f64::from(n) * spacing_m);
    format!(
        "spacing_m = {spacing_m}\ngravity_m_s2 = [0, {}, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{}, {}, {z}]\n\
         [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [{x}, {y}, {z}] }}\n\
         [outputs]\nmeasure_every_steps = 1\n",
        -500.0 * spacing_m,
        2.0 * x,
        1.5 * y
    )
}

fn run(spacing_m: f64, counts: [u32; 3], steps: u32) -> (State, Stats) {
    let mut case = Case::new(&dam(spacing_m, counts), &["solver.deterministic=true"]);
    let stats = case.run(steps);
    (case.state(), stats)
}

#[test]
fn powers_of_two_change_no_bit() {
    let (here, _) = run(0.015625, [4, 4, 4], 240);
    for scale in [2.0_f32.powi(-10), 2.0_f32.powi(10)] {
        let (there, _) = run(0.015625 * f64::from(scale), [4, 4, 4], 240);
        let scaled = |values: &[[f32; 3]]| -> Vec<[f32; 3]> { values.iter().map(|v| v.map(|x| x * scale)).collect() };
        assert_eq!(scaled(&here.positions), there.positions, "scale {scale}");
        assert_eq!(scaled(&here.velocities), there.velocities, "scale {scale}");
    }
    println!("case 7: 64 particles, 240 steps, scales 2^-10, 1, 2^10: every bit equal");
}

#[test]
fn a_thousandth_and_a_thousandfold_are_alike() {
    let counts = [10, 10, 10];
    let soon = run(0.02, counts, 10).0;
    let late = run(0.02, counts, 240).1;
    for scale in [1.0e-3, 1.0e3] {
        let spacing_m = 0.02 * scale;
        let mut largest = 0.0_f64;
        for (a, b) in soon.positions.iter().flatten().zip(run(spacing_m, counts, 10).0.positions.iter().flatten()) {
            largest = largest.max((f64::from(*a) - f64::from(*b) / scale).abs() / 0.02);
        }
        // Quantization of 2e-6 h are rounded elsewhere in 40 iterations; crowded particles multiply that ten-fold
        // in about as many steps. Measured: .0016 and .00012; .00013 at both scales with plain iterations, where no
        // rounding decides on which side of rest density momentum ends.
        assert!(largest < 2.5e-3, "scale {scale}: {largest} spacings apart after 10 steps");
        let stats = run(spacing_m, counts, 240).1;
        let ratio = |there: f64, here: f64| there / scale / here - 1.0;
        let centre = ratio(stats.centre_of_mass_m[1], late.centre_of_mass_m[1]);
        let front = ratio(stats.front_m, late.front_m);
        let compression = stats.compression.mean - late.compression.mean;
        println!(
            "case 7: scale {scale}: {largest:.1e} d apart after 10 steps; after 240: centre of mass {:.2} %, front {:.2} %, mean compression {compression:.1e} off",
            100.0 * centre,
            100.0 * front
        );
        // Particles have mixed by now: means agree, within a tenth of a spacing of 5.
        assert!(centre.abs() < 0.02 && front.abs() < 0.02 && compression.abs() < 5.0e-3);
    }
}

#[test]
fn the_smallest_and_the_largest_come_to_rest() {
    for scale in [1.0e-3, 1.0e3] {
        let mut case = Case::new(&dam(0.02 * scale, [8, 8, 8]), &[]);
        case.run(600);
        let stats = case.run(200);
        let in_spacings = stats.max_speed_m_s / (0.02 * scale);
        println!("case 7: scale {scale}: {in_spacings:.2} spacings a second at rest, {:?}", stats.compression);
        // As `recovers`, whose limit is in metres: falling one spacing.
        assert!(in_spacings < (2.0_f64 * 500.0).sqrt() && stats.compression.p99 < 0.1);
        assert_eq!((stats.counters.speed_clamps, stats.counters.neighbour_overflow), (0, 0));
    }
}
