//! Case 6: a scene 10 km from the origin does what it does at the origin, bit for bit: positions on
//! the GPU are relative to the domain.

use brooklet_tests::extreme::{Case, State};

/// 64 particles in a corner.
fn drop_at(origin_m: f64, spacing_m: f64) -> String {
    let at = |spacings: f64| origin_m + spacings * spacing_m;
    format!(
        "spacing_m = {spacing_m}\n[domain]\nmin_m = [{0}, {0}, {0}]\nmax_m = [{1}, {1}, {1}]\n\
         [[fluid]]\nblock = {{ min_m = [{0}, {2}, {0}], max_m = [{3}, {4}, {3}] }}\nvelocity_m_s = [0.5, 0, 0.25]\n\
         [outputs]\nmeasure_every_steps = 1\n",
        at(0.0),
        at(12.0),
        at(3.0),
        at(4.0),
        at(7.0)
    )
}

fn after(text: &str, steps: u32) -> (State, State, f64) {
    let mut case = Case::new(text, &["solver.deterministic=true"]);
    assert_eq!(case.count(), 64);
    let start = case.state();
    let stats = case.run(steps);
    (start, case.state(), stats.centre_of_mass_m[1])
}

#[test]
fn ten_kilometres_away_nothing_changes() {
    // A power of two, so that the scene's own f64 coordinates are exact in both places.
    let spacing_m = 0.015625;
    let (start, here, height_m) = after(&drop_at(0.0, spacing_m), 240);
    for origin_m in [1.0e4, -1.0e4] {
        let (start_there, there, height_there_m) = after(&drop_at(origin_m, spacing_m), 240);
        assert_eq!(start, start_there);
        assert_eq!(here, there, "at {origin_m} m");
        assert!((height_there_m - origin_m - height_m).abs() < 1.0e-9, "{height_there_m} {height_m}");
    }
    assert_ne!(start, here, "nothing moved");
    println!("case 6: 64 particles, 240 steps, at 0 and +-10 km: every bit equal");
    Case::new(&drop_at(1.0e4, spacing_m), &[]).recovers(3.0);
}

#[test]
fn a_spacing_that_f64_rounds_is_off_by_that_rounding_alone() {
    let at = |origin_m: f64| Case::new(&drop_at(origin_m, 0.02), &[]).state();
    let (here, there) = (at(0.0), at(1.0e4));
    let mut largest = 0.0_f32;
    for (a, b) in here.positions.iter().flatten().zip(there.positions.iter().flatten()) {
        largest = largest.max((a - b).abs());
    }
    // f64 at 10 km: steps of 1.8e-12 m; then each is rounded to f32 below 0.25 m.
    assert!(largest <= 0.25 * f32::EPSILON, "{largest:e}");
    println!("case 6: spacing 0.02 m: starts differ by at most {largest:.1e} m");
}
