//! Case 14: a jet at 100 m/s. It goes through no wall and no other fluid; where the speed limit
//! slows it, that is counted, and with enough substeps it is not slowed.

use brooklet_tests::extreme::{Case, State};

/// A jet of 6 x 6 x 20 particles, and a plug of 6 x 6 x 10 at rest that fills the channel before it.
const CHANNEL: &str = "
spacing_m = 0.02
gravity_m_s2 = [0, 0, 0]
[domain]
min_m = [0, 0, 0]
max_m = [1.6, 0.12, 0.12]
[[fluid]]
block = { min_m = [0.0, 0, 0], max_m = [0.4, 0.12, 0.12] }
velocity_m_s = [100, 0, 0]
[[fluid]]
block = { min_m = [0.6, 0, 0], max_m = [0.8, 0.12, 0.12] }
[outputs]
measure_every_steps = 1
";
const JET: usize = 6 * 6 * 20;

/// Mean x of the jet and of the plug, how many of the jet's particles are ahead of the plug's middle, and whether the
/// plug lies at the far wall: what mixes there went through nothing.
fn places(state: &State) -> (f64, f64, usize, bool) {
    let x: Vec<f64> = state.positions.iter().map(|p| f64::from(p[0])).collect();
    let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
    let (jet, plug) = x.split_at(JET);
    let middle = mean(plug);
    let front = plug.iter().copied().fold(0.0, f64::max);
    (mean(jet), middle, jet.iter().filter(|x| **x > middle).count(), front > 1.6 - 0.02)
}

#[test]
fn a_jet_at_the_limit_is_clamped_and_counted() {
    let mut case = Case::new(CHANNEL, &[]);
    let limit_m_s = case.scene().max_speed_m_s();
    assert!(limit_m_s < 10.0);
    let first = case.run(1);
    println!(
        "case 14: limit {limit_m_s:.1} m/s, first step: {:?}, fastest {:.2} m/s",
        first.counters, first.max_speed_m_s
    );
    assert!(first.counters.speed_clamps as usize >= JET, "{:?}", first.counters);
    let (mut through, mut seen) = (0, 0);
    for _ in 0..12 {
        case.run(5);
        let (jet_m, plug_m, ahead, at_wall) = places(&case.state());
        if at_wall {
            break;
        }
        seen += usize::from(plug_m > 0.75 && jet_m < plug_m);
        through = through.max(ahead);
    }
    assert!(seen > 2, "the jet is seen to drive the plug before it");
    println!("case 14: at most {through} of {JET} particles of the jet were ahead of the plug's middle");
    assert_eq!(through, 0, "the jet went through the plug");
    case.run(180);
    // Thrown together and without gravity, it stills.
    case.recovers(4.0);
}

#[test]
fn with_enough_substeps_nothing_is_clamped_before_the_impact() {
    // 0.6 h a substep at 172 m/s: room for the jet, and for some of what the impact adds.
    let mut case = Case::new(CHANNEL, &["solver.dt_s=0.0004166666667", "solver.substeps=3"]);
    let start = case.state();
    // The gap of 10 d is 4.8 steps wide.
    let stats = case.run(4);
    assert_eq!((stats.counters.speed_clamps, stats.counters.correction_clamps), (0, 0), "{:?}", stats.counters);
    let state = case.state();
    let flown_m = (0..JET).map(|id| f64::from(state.positions[id][0] - start.positions[id][0]));
    let (least_m, most_m) = flown_m.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    // 12 substeps at 100 m/s. Measured: .16628 to .16706 m; .16644 to .16689 with plain iterations.
    assert!(least_m > 0.166 && most_m < 0.1675, "flew {least_m} to {most_m} m");
    let mut through = 0;
    for _ in 0..20 {
        case.run(1);
        through = through.max(places(&case.state()).2);
    }
    println!(
        "case 14: 3 substeps of 0.14 ms: flew {least_m:.4} to {most_m:.4} m in 4 steps; {through} of {JET} went past the plug's middle"
    );
    assert_eq!(through, 0, "the jet went through the plug");
}
