//! Case 20: 5,000 steps of 1,000 particles at rest (`examples/rest.rs` has 10,000). Energy decays, nothing drifts.

use brooklet_tests::extreme::Case;
use brooklet_tests::pool::POOL;
use glam::DVec3;

#[test]
fn five_thousand_steps_at_rest() {
    let mut case = Case::new(POOL, &[]);
    assert_eq!(case.count(), 1000);
    let mass_kg = 8.0;
    let mut history = Vec::new();
    for _ in 0..10 {
        let stats = case.run(500);
        println!(
            "case 20: kinetic {:.2e} J, potential {:.4} J, centre of mass {:?} m, momentum {:.1e} kg m/s",
            stats.kinetic_j,
            stats.potential_j,
            stats.centre_of_mass_m,
            DVec3::from_array(stats.momentum_kg_m_s).length()
        );
        assert_eq!((stats.particles, stats.quarantined), (1000, 0));
        history.push(stats);
    }
    // After it settled: at most what falling a hundredth of a spacing gives each particle.
    let still_j = mass_kg * 9.81 * 0.01 * 0.02;
    for stats in &history {
        assert!(stats.kinetic_j < still_j, "{} J after it settled", stats.kinetic_j);
    }
    let (first, last) = (history[0], history[9]);
    let energy = |stats: &brooklet_fluid::Stats| stats.kinetic_j + stats.potential_j;
    // It may go on packing, never rise: f32 measures the sums to 1e-6 of them.
    assert!(energy(&last) - energy(&first) < 1.0e-5 * energy(&first), "energy rises from {first:?} to {last:?}");
    for axis in 0..3 {
        let drift_m = last.centre_of_mass_m[axis] - first.centre_of_mass_m[axis];
        assert!(drift_m.abs() < 0.05 * 0.02, "the middle drifts by {drift_m} m along axis {axis}");
    }
    println!("case 20: compression {:?}", last.compression);
    // 1.5 times what is measured.
    assert!(last.compression.p99 < 0.025, "{:?}", last.compression);
}
