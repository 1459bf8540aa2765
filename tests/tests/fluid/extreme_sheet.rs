//! Case 13: a sheet one layer thick. Its particles do not clump; holes are accepted.

use brooklet_tests::extreme::Case;
use brooklet_tests::rng;
use rand::RngExt;

const SHEET: &str = "
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [0.64, 0.3, 0.64]
[[fluid]]
block = { min_m = [0.06, 0.2, 0.06], max_m = [0.58, 0.22, 0.58] }
[outputs]
measure_every_steps = 1
";

#[test]
fn a_falling_sheet_spreads_without_clumping() {
    let mut case = Case::new(SHEET, &[]);
    assert_eq!(case.count(), 26 * 26);
    let mut rng = rng(13);
    // Along the sheet each moves its own way, a spacing in a tenth of a second.
    case.place(|_, _, velocity_m_s| {
        *velocity_m_s = [0.4 * (rng.random::<f32>() - 0.5), 0.0, 0.4 * (rng.random::<f32>() - 0.5)];
    });
    case.run(240);
    case.recovers(1.0);
    let mut nearest = case.state().nearest_m();
    nearest.iter_mut().for_each(|distance| *distance /= 0.02);
    nearest.sort_by(f64::total_cmp);
    let close = nearest.iter().filter(|distance| **distance < 0.5).count();
    println!(
        "case 13: nearest neighbours at least {:.2} d, 1 % within {:.2} d, median {:.2} d; {close} of {} within d/2",
        nearest[0],
        nearest[nearest.len() / 100],
        nearest[nearest.len() / 2],
        nearest.len()
    );
    assert!(nearest[0] > 0.2, "two particles are {} spacings apart", nearest[0]);
    assert!(nearest[nearest.len() / 2] > 0.7 && close * 20 < nearest.len(), "{close} are within half a spacing");
    // One layer on the floor, and nothing on top of it.
    let highest = case.state().positions.iter().map(|p| p[1]).fold(0.0, f32::max);
    assert!(highest < 0.03, "something stands {highest} m high");
}
