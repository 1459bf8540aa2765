//! A hundred thousand particles in one cell: each would look at all others. The search is bounded, and says so.

use brooklet_kernels::MAX_CANDIDATES;
use brooklet_tests::extreme::Case;
use brooklet_tests::rng;
use rand::RngExt;

const COUNT: usize = 100_000;

#[test]
fn a_hundred_thousand_in_one_cell_are_bounded_work_and_counted() {
    let scene = "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1.0, 1.0, 1.0]\n\
         [[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [1.0, 0.8, 1.0] }\n\
         [outputs]\nmeasure_every_steps = 1\n";
    for deterministic in [false, true] {
        let mut case = Case::new(scene, &[&format!("solver.deterministic={deterministic}"), "solver.pbf.iterations=1"]);
        assert_eq!(case.count(), COUNT);
        let mut rng = rng(100);
        // Cells are h/2 = 0.02 m wide; the 25th of each axis.
        case.place(|_, position_m, _| *position_m = [0; 3].map(|_| 0.5 + 0.02 * rng.random::<f32>()));
        let stats = case.run(1);
        println!("100,000 in one cell, one step, deterministic = {deterministic}: {:?}", stats.counters);
        assert_eq!(stats.counters.crowded as usize, COUNT, "each has more candidates than {MAX_CANDIDATES}");
        assert!(stats.counters.neighbour_overflow > 0, "{:?}", stats.counters);
    }
}

#[test]
fn as_many_as_are_looked_at_are_not_crowded() {
    let at_most = |count: usize| {
        let [x, y] = [count.min(64), count.div_ceil(64)].map(|n| 0.02 * n as f64);
        let scene = format!(
            "spacing_m = 0.02\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1.4, 1.4, 0.4]\n\
             [[fluid]]\nblock = {{ min_m = [0.02, 0.02, 0.02], max_m = [{}, {}, 0.04] }}\n\
             [outputs]\nmeasure_every_steps = 1\n",
            x + 0.02,
            y + 0.02
        );
        let mut case = Case::new(&scene, &["solver.pbf.iterations=0"]);
        assert_eq!(case.count(), count);
        case.place(|_, position_m, _| *position_m = [0.21, 0.21, 0.21]);
        case.run(1).counters.crowded as usize
    };
    let most = MAX_CANDIDATES as usize;
    assert_eq!(at_most(most), 0);
    assert_eq!(at_most(most + 64), most + 64);
}
