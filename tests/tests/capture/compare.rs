//! `compare` on made-up runs whose noise is like that of a busy machine: it finds a slowdown that was put in,
//! and raises an alarm in at most one of 20 comparisons of the same with the same.

use brooklet_capture::{Comparison, Differences, FRAME, Times, Verdict};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const STAGES: usize = 12;
const FRAMES: usize = 600;

/// A run: times that stay alike from frame to frame, a drift over the run that all passes have, a common noise
/// of the machine, and outliers. `factor` is what each pass's time is multiplied by.
fn run(rng: &mut ChaCha8Rng, factor: impl Fn(usize) -> f64) -> Times {
    let mut normal = || -> f64 { (0..12).map(|_| rng.random::<f64>()).sum::<f64>() - 6.0 };
    let (drift, phase) = (0.04 * normal(), normal());
    let mut machine = 0.0;
    let common: Vec<f64> = (0..FRAMES)
        .map(|frame| {
            machine = 0.95 * machine + 0.01 * normal();
            let part = frame as f64 / FRAMES as f64;
            1.0 + machine + drift * (part - 0.5) + 0.01 * (6.0 * part + phase).sin()
        })
        .collect();
    let mut frames = vec![0.0_f32; FRAMES];
    let mut stages = Vec::new();
    for stage in 0..STAGES {
        let mut own = 0.0;
        let base = 0.05 * 1.4_f64.powi(stage as i32) * factor(stage);
        let times: Vec<f32> = common
            .iter()
            .map(|common| {
                own = 0.8 * own + 0.03 * normal();
                let outlier = if normal() > 2.0 { 1.0 + normal().abs() } else { 1.0 };
                (base * (common + own).max(0.1) * outlier) as f32
            })
            .collect();
        frames.iter_mut().zip(&times).for_each(|(frame, ms)| *frame += ms);
        stages.push((format!("stage_{stage}"), times));
    }
    stages.insert(0, (FRAME.into(), frames));
    Times { stages, ..Times::default() }
}

fn plain(rng: &mut ChaCha8Rng) -> Times {
    run(rng, |_| 1.0)
}

#[test]
fn the_same_against_the_same_raises_one_alarm_in_20_at_most() {
    let mut rng = ChaCha8Rng::seed_from_u64(20_261_122);
    let comparisons = 100;
    let (mut beyond, mut told) = (0, 0);
    for _ in 0..comparisons {
        let comparison = Comparison::of(&plain(&mut rng), &plain(&mut rng));
        assert_eq!(comparison.passes.len(), STAGES + 1);
        beyond += usize::from(!comparison.slower_than(0.05).is_empty());
        told += usize::from(comparison.passes.iter().any(|pass| pass.verdict != Verdict::NotTold));
    }
    println!("of {comparisons}: {beyond} alarms beyond 5 %, {told} with any pass told apart");
    assert!(beyond * 20 <= comparisons, "{beyond} alarms beyond 5 % in {comparisons}");
    // 5 % by design; 100 draws of that have a standard error of 2.2 %, and three of them are allowed for.
    assert!(told * 1000 <= 115 * comparisons, "{told} of {comparisons} told passes apart that are the same");
}

#[test]
fn a_pass_that_is_15_percent_slower_is_found_and_no_other() {
    let mut rng = ChaCha8Rng::seed_from_u64(4711);
    let runs = 40;
    let (mut found, mut others) = (0, 0);
    for number in 0..runs {
        let slowed = number % STAGES;
        let b = run(&mut rng, |stage| if stage == slowed { 1.15 } else { 1.0 });
        let comparison = Comparison::of(&plain(&mut rng), &b);
        let slower: Vec<&str> = comparison.slower_than(0.05).iter().map(|pass| &*pass.stage).collect();
        found += usize::from(slower.contains(&&*format!("stage_{slowed}")));
        // The whole frame may be slower with it.
        others += slower.iter().filter(|stage| **stage != FRAME && **stage != format!("stage_{slowed}")).count();
    }
    println!("found in {found} of {runs}, {others} alarms for other passes");
    assert!(found * 10 >= runs * 9, "found in {found} of {runs}");
    assert!(others * 20 <= runs, "{others} false alarms");
}

#[test]
fn a_comparator_that_takes_frames_for_independent_would_raise_alarms() {
    // The same noise without blocks: what the intervals would be if each frame were a draw of its own. It is
    // wrong, and this test's noise shows it; so the test above can fail.
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let comparisons = 40;
    let mut told = 0;
    for _ in 0..comparisons {
        let mut shuffled = || {
            let mut times = plain(&mut rng);
            for (_, frames) in &mut times.stages {
                for place in (1..frames.len()).rev() {
                    frames.swap(place, rng.random_range(0..=place));
                }
            }
            times
        };
        let comparison = Comparison::of(&shuffled(), &shuffled());
        told += usize::from(comparison.passes.iter().any(|pass| pass.verdict != Verdict::NotTold));
    }
    println!("{told} of {comparisons}");
    assert!(told * 5 > comparisons, "only {told} of {comparisons}: the noise is too tame for the tests above");
}

#[test]
fn the_same_times_are_the_same_and_results_repeat() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let a = plain(&mut rng);
    let same = Comparison::of(&a, &a);
    assert!(same.passes.iter().all(|pass| pass.ratio == 1.0 && pass.verdict == Verdict::NotTold));
    let b = run(&mut rng, |_| 2.0);
    let twice = Comparison::of(&a, &b);
    assert!(twice.passes.iter().all(|pass| (1.8..2.2).contains(&pass.ratio) && pass.verdict == Verdict::Slower));
    let half = Comparison::of(&b, &a);
    assert!(half.passes.iter().all(|pass| pass.verdict == Verdict::Faster) && half.slower_than(0.0).is_empty());
    let again = Comparison::of(&a, &b);
    for (one, other) in twice.passes.iter().zip(&again.passes) {
        assert_eq!(one.interval, other.interval);
    }
}

#[test]
fn what_cannot_be_compared_is_named() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let (mut a, mut b) = (plain(&mut rng), plain(&mut rng));
    a.stages[1].1.truncate(8);
    b.stages[2].1.fill(0.0);
    a.stages[3].0 = "old_name".into();
    b.stages.push(("overlay".into(), vec![1.0; 100]));
    let comparison = Comparison::of(&a, &b);
    let why = |stage: &str| {
        let found = comparison.left_out.iter().find(|(left_out, _)| left_out == stage);
        found.map_or("", |(_, why)| why)
    };
    assert!(why("stage_0").contains("6 frames, and 20 are needed"), "{:?}", comparison.left_out);
    assert!(why("stage_1").contains("no time at all"));
    assert_eq!((why("old_name"), why("stage_2"), why("overlay")), ("only A has it", "only B has it", "only B has it"));
    assert_eq!(comparison.passes.len() + comparison.left_out.len(), STAGES + 3);
}

#[test]
fn different_scenes_devices_and_settings_are_told() {
    let mut a = Times { scene: Some(("dam.toml".into(), "x = 1\ny = 2\n".into())), ..Times::default() };
    let fields = |name: &str| [("device".to_string(), [("name".to_string(), name.to_string())].into())].into();
    a.metadata = fields("llvmpipe");
    let mut b = a.clone();
    assert_eq!(Differences::of(&a, &b), Differences::default());
    b.scene = Some(("dam.toml".into(), "x = 1\ny = 3\n".into()));
    b.metadata = fields("SwiftShader");
    b.settings = vec!["desktop full water rung 0".into(), "desktop half water rung 1".into()];
    let told = Differences::of(&a, &b);
    assert_eq!(told.scenes.as_deref(), Some("dam.toml, with other settings: `y = 2` and `y = 3`"));
    assert!(told.others.contains(&"device name: llvmpipe and SwiftShader".to_string()), "{told:?}");
    assert!(told.others.iter().any(|other| other.starts_with("B changed its settings while it ran")), "{told:?}");
    b.scene = Some(("pool.toml".into(), String::new()));
    assert_eq!(Differences::of(&a, &b).scenes.as_deref(), Some("dam.toml and pool.toml"));
    b.scene = None;
    assert!(Differences::of(&a, &b).scenes.is_some());
}
