//! The dam break's front against Martin & Moyce 1952 (n² = 2).
//!
//! The front is the largest x of any particle plus half a spacing, thin spray ahead of the body
//! included; Z is the front over the column's base a, T is t √(2g/a).

use brooklet_fluid::{Scene, Session};
use brooklet_reference::dam_break::{Sample, compare, parse_series};
use brooklet_tests::gpu_of_long_run;

const BASE_M: f64 = 0.05715;

fn experiment() -> Vec<Sample> {
    parse_series(include_str!("../../../app/study/data/martin_moyce_n2_2_front.csv")).unwrap()
}

#[test]
fn front_follows_martin_and_moyce() {
    // A slice eight particles wide: the front does not feel the width, and a CPU driver does.
    let settings = ["domain.max_m.2=0.02286", "fluid.0.block.max_m.2=0.02286"].map(String::from);
    let scene = Scene::load("martin-moyce", &settings).unwrap();
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    let mut front = Vec::new();
    let per_t = (2.0 * 9.81 / BASE_M).sqrt();
    for step in 1..=500_u32 {
        session.step().unwrap();
        if step % 4 == 0 {
            session.measure().unwrap();
            session.finish().unwrap();
            let stats = session.stats().unwrap();
            front.push((f64::from(step) * scene.solver.dt_s * per_t, stats.front_m / BASE_M));
        }
    }
    let compared = compare(&front, &experiment()).unwrap();
    println!("dam break front: {compared:?}");
    // Digitised data agree among themselves within 0.06; particle methods of this resolution lead
    // or lag by a few tenths of a base over a run of fourteen. 1.5 times what is measured: .44, .18 and 5.9 %.
    assert!(compared.rmse < 0.65, "{compared:?}");
    assert!(compared.shifted_rmse < 0.27, "{compared:?}");
    assert!((compared.slope / compared.expected_slope - 1.0).abs() < 0.088, "{compared:?}");
}

#[test]
fn a_front_that_is_wrong_is_noticed() {
    let slow: Vec<Sample> = experiment().iter().map(|&(t, z)| (t, 1.0 + 0.7 * (z - 1.0))).collect();
    let compared = compare(&slow, &experiment()).unwrap();
    assert!(
        compared.shifted_rmse > 0.27 && (compared.slope / compared.expected_slope - 1.0).abs() > 0.088,
        "{compared:?}"
    );
}
