//! Cases 2 and 3: 2, 64 and 1,000 particles at one point, and 1,000 in one cell. They separate, no
//! faster than the speed limit; neighbours beyond the slots are counted.

use brooklet_tests::extreme::Case;
use brooklet_tests::rng;
use rand::RngExt;

/// Particles in a box that is large enough for all of them in a few layers.
fn in_a_box(counts: [usize; 3]) -> String {
    let [x, y, z] = counts.map(|n| 0.2 + 0.02 * n as f64);
    format!(
        "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [0.4, 0.6, 0.4]\n\
         [[fluid]]\nblock = {{ min_m = [0.2, 0.2, 0.2], max_m = [{x}, {y}, {z}] }}\n\
         [outputs]\nmeasure_every_steps = 1\n"
    )
}

#[test]
fn particles_at_one_point_separate() {
    for counts in [[2, 1, 1], [4, 4, 4], [10, 10, 10]] {
        let mut case = Case::new(&in_a_box(counts), &["gravity_m_s2=[0,0,0]"]);
        let count = case.count();
        assert_eq!(count, counts.iter().product::<usize>());
        case.place(|_, position_m, _| *position_m = [0.2, 0.3, 0.2]);
        let stats = case.run(60);
        let mut nearest_m = case.state().nearest_m();
        nearest_m.sort_by(f64::total_cmp);
        println!(
            "case 2: {count} at one point, after 60 steps: nearest {:.2} d, median nearest {:.2} d, {:?}",
            nearest_m[0] / 0.02,
            nearest_m[count / 2] / 0.02,
            stats.counters
        );
        // None is left at the point, and all but one in a hundred, which others drive, are well apart.
        let parted = nearest_m[0] > 0.02 * 0.02 && nearest_m[count / 100] > 0.2 * 0.02;
        assert!(parted, "{count} particles: nearest {} m, {} m", nearest_m[0], nearest_m[count / 100]);
        // A list holds 48: of so many the rest is counted.
        assert_eq!(stats.counters.neighbour_overflow > 0, count > 49, "{count} particles: {:?}", stats.counters);
    }
}

#[test]
fn particles_at_one_point_come_to_rest_as_a_pool() {
    let mut case = Case::new(&in_a_box([10, 10, 10]), &[]);
    case.place(|_, position_m, _| *position_m = [0.2, 0.3, 0.2]);
    let stats = case.recovers(4.0);
    println!("case 2: 1000 at one point, at rest: {:?}, at most {} m/s", stats.compression, stats.max_speed_m_s);
}

#[test]
fn all_particles_in_one_cell_spread() {
    let mut case = Case::new(&in_a_box([10, 10, 10]), &[]);
    let mut rng = rng(3);
    // Cells are h/2 = 0.02 m wide; the tenth of each axis.
    case.place(|_, position_m, _| *position_m = [0; 3].map(|_| 0.2 + 0.02 * rng.random::<f32>()));
    let stats = case.run(10);
    println!("case 3: 1000 in one cell, after 10 steps: {:?}", stats.counters);
    assert!(stats.counters.neighbour_overflow > 0, "{:?}", stats.counters);
    let stats = case.recovers(4.0);
    println!("case 3: at rest: {:?}, at most {} m/s", stats.compression, stats.max_speed_m_s);
}
