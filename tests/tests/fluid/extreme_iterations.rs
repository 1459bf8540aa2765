//! A thousand iterations a substep: they move nobody by a support radius, from where quantized positions would come round to
//! the other side, 4 h away.

use brooklet_tests::extreme::Case;
use glam::Vec3;

const SUPPORT_M: f32 = 0.04;

#[test]
fn a_thousand_iterations_move_no_particle_by_a_support() {
    for precision in ["full", "relaxed"] {
        let scene = "spacing_m = 0.02\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n\
             [[fluid]]\nblock = { min_m = [0.2, 0.2, 0.2], max_m = [0.36, 0.36, 0.36] }\n\
             [outputs]\nmeasure_every_steps = 1\n";
        let settings = [
            "solver.pbf.iterations=1000",
            "forces.xsph=0",
            "solver.neighbour_slots=512",
            &format!("solver.precision={precision}"),
        ];
        let mut case = Case::of_few_steps(scene, &settings);
        assert_eq!(case.count(), 512);
        // All but one point, each the neighbour of all others: a ball of them is 2.5 h in radius.
        case.place(|_, position_m, _| *position_m = position_m.map(|x| 0.5 + 0.05 * (x - 0.28)));
        let before = case.state();
        let stats = case.run(1);
        let after = case.state();
        let moved = before.positions.iter().zip(&after.positions);
        let furthest_m = moved.map(|(a, b)| Vec3::from(*a).distance((*b).into())).fold(0.0, f32::max);
        println!("1,000 iterations, {precision}: furthest {:.4} h, {:?}", furthest_m / SUPPORT_M, stats.counters);
        assert!(furthest_m > 0.9 * SUPPORT_M, "the case was meant to meet the limit: {furthest_m} m");
        assert!(furthest_m < SUPPORT_M, "{furthest_m} m");
        assert!(stats.counters.displacement_clamps > 0, "{:?}", stats.counters);
    }
}
