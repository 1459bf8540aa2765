//! Case 21: fluid driven into a corner of the box, and particles clamped to one plane of it. They
//! do not pile up there, and none is ejected late.

use brooklet_tests::extreme::Case;
use brooklet_tests::rng;
use rand::RngExt;

const CORNER: &str = "
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [0.24, 0.4, 0.24]
[[fluid]]
block = { min_m = [0.0, 0.0, 0.0], max_m = [0.16, 0.16, 0.16] }
[outputs]
measure_every_steps = 1
";

/// Comes to rest, and then nothing is faster than what rest allows, for half a second.
fn rests_for_good(case: &mut Case, what: &str) {
    let stats = case.recovers(3.0);
    let mut fastest_m_s = 0.0_f64;
    for _ in 0..24 {
        fastest_m_s = fastest_m_s.max(case.run(5).max_speed_m_s);
    }
    let nearest_m = case.state().nearest_m().into_iter().fold(f64::INFINITY, f64::min);
    println!(
        "case 21: {what}: compression at rest {:?}, nearest pair {:.2} d, fastest in the next 0.5 s {fastest_m_s:.3} m/s",
        stats.compression,
        nearest_m / 0.02
    );
    // Falling half a spacing.
    assert!(fastest_m_s < 0.45, "{what}: ejected late at {fastest_m_s} m/s");
}

#[test]
fn a_block_thrown_into_a_corner_does_not_stay_piled_up() {
    let mut case = Case::new(CORNER, &[]);
    // Faster than the pool's own waves by far; below the limit, 9.6 m/s.
    case.place(|_, _, velocity_m_s| *velocity_m_s = [-5.0, -5.0, -5.0]);
    let stats = case.run(10);
    println!("case 21: thrown, after 10 steps: {:?}, {:?}", stats.compression, stats.counters);
    rests_for_good(&mut case, "thrown into the corner");
}

#[test]
fn particles_clamped_to_one_plane_leave_it() {
    let mut case = Case::new(CORNER, &[]);
    let mut rng = rng(21);
    // Outside, so that the walls clamp all of them to one plane, eight times as many as it has room for.
    case.place(|_, position_m, _| {
        *position_m = [-0.01, 0.16 * rng.random::<f32>(), 0.16 * rng.random::<f32>()];
    });
    let stats = case.run(1);
    println!("case 21: clamped to a plane, after a step: {:?}, {:?}", stats.compression, stats.counters);
    rests_for_good(&mut case, "clamped to one plane");
    let on_the_plane = case.state().positions.iter().filter(|p| p[0] < 0.011).count();
    // At rest the pool is about 4 layers of 12 x 12 high: 48 particles stand along a wall.
    println!("case 21: {on_the_plane} of {} particles are left at the plane", case.count());
    assert!(on_the_plane < 80, "{on_the_plane} particles are still at the wall");
}
