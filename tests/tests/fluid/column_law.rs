//! The column law (`brooklet_reference::column`): what iterations leave of a column's compression.
//!
//! The column is 4 particles wide between walls, of which the middle 2 x 2 are looked at: walls add
//! no neighbours whose gradients count, so beside them lambda is larger and the compression smaller.
//! `examples/column_law.rs` shows that wider columns differ by a hundredth, and more cases.

use brooklet_fluid::scene::Acceleration;
use brooklet_tests::column::{Settled, Setup};
use brooklet_tests::extreme::Case;

const COLUMN: Setup =
    Setup { layers: 60, width: 4, iterations: 4, substeps: 1, dt_s: 1.0 / 240.0, acceleration: Acceleration::None };

/// The law holds to this where it says .015 to .15: 1.5 times the largest error measured, 4.5 %.
const TOLERANCE: f64 = 0.07;

fn check(settled: &Settled, law: f64) -> Result<(), String> {
    let off = settled.bottom / law - 1.0;
    // Swings would make a lucky moment of it.
    if off.abs() <= TOLERANCE && settled.unrest < 0.1 * law {
        return Ok(());
    }
    Err(format!("measured {} +- {}, the law says {law}", settled.bottom, settled.unrest))
}

#[test]
fn four_eight_and_sixteen_iterations_leave_what_the_law_says() {
    for (iterations, compression) in [(4, 0.15), (8, 0.1), (16, 0.05)] {
        let setup = Setup { iterations, ..COLUMN }.at(compression);
        let settled = setup.settle();
        println!("column of 60, {iterations} iterations: law {:.4}, measured {:.4}", settled.law, settled.bottom);
        assert!((settled.law - compression).abs() < 1.0e-12);
        check(&settled, settled.law).unwrap();
        // The law of half as many iterations, or twice: told apart.
        check(&settled, 0.5 * settled.law).unwrap_err();
        check(&settled, 2.0 * settled.law).unwrap_err();
    }
}

#[test]
fn accelerated_iterations_leave_what_the_law_says_below_their_guard() {
    for (iterations, compression) in [(4, 0.03), (8, 0.02)] {
        let setup = Setup { iterations, acceleration: Acceleration::Chebyshev, ..COLUMN }.at(compression);
        let settled = setup.settle();
        println!(
            "accelerated column of 60, {iterations} iterations: law {compression}, measured {:.4}",
            settled.bottom
        );
        check(&settled, settled.law).unwrap();
        // Of plain iterations the law says more than twice as much.
        let plain = Setup { acceleration: Acceleration::None, ..setup }.column().bottom_compression();
        assert!(plain > 2.0 * settled.law, "{plain} {}", settled.law);
    }
}

/// 60 layers between periodic sides, from the lattice. The law of plain iterations says 10 % for the bottom.
const TALL: &str = "
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [0.16, 1.4, 0.16]
periodic = [true, false, true]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.16, 1.2, 0.16] }
[solver]
dt_s = 0.003790
[outputs]
measure_every_steps = 1
";

#[test]
fn a_coarse_correction_leaves_less_than_a_tenth_of_it() {
    let most = |settings: &[&str], steps: u32| {
        let mut case = Case::new(TALL, settings);
        case.run(steps);
        case.run(1).compression.p99
    };
    let law = COLUMN.at(0.1);
    assert!((law.dt_s / 0.003790 - 1.0).abs() < 1e-3, "{law:?}");
    let (with, without) = (most(&[], 150), most(&["solver.pbf.coarse_correction=false"], 75));
    println!(
        "column of 60, law 10 %: {:.2} % with a coarse correction, {:.2} % without",
        100.0 * with,
        100.0 * without
    );
    assert!(with < 0.01 && without > 0.02, "{with} {without}");
}

#[test]
fn substeps_beat_iterations() {
    // 8 iterations in all a step: the law says eps / substeps.
    let step = Setup { layers: 30, iterations: 8, ..COLUMN }.at(0.12);
    let mut before = f64::INFINITY;
    for substeps in [1, 2, 4, 8] {
        let settled = Setup { substeps, iterations: 8 / substeps, ..step }.settle();
        println!(
            "column of 30, {substeps} substeps x {} iterations: law {:.4}, measured {:.4}",
            8 / substeps,
            settled.law,
            settled.bottom
        );
        check(&settled, 0.12 / f64::from(substeps)).unwrap();
        assert!(settled.bottom < 0.65 * before, "{substeps} substeps");
        before = settled.bottom;
    }
}
