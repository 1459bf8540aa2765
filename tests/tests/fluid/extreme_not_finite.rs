//! Case 17: NaN and infinity in some particles, in every component. They are quarantined by their
//! bits and spread nothing. Absurd but finite values are no reason to lose a particle.

use brooklet_tests::extreme::Case;

const POOL: &str = "
spacing_m = 0.025
[domain]
min_m = [0, 0, 0]
max_m = [0.25, 0.5, 0.25]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.25, 0.25, 0.25] }
[outputs]
measure_every_steps = 1
";

/// Quiet and signalling, of either sign, with and without payload.
fn not_finite() -> [f32; 6] {
    [0x7fc0_0000, 0xffc0_0000, 0x7f80_0001, 0xffff_ffff, 0x7f80_0000, 0xff80_0000].map(f32::from_bits)
}

#[test]
fn what_is_not_finite_is_quarantined_and_spreads_nothing() {
    let mut case = Case::new(POOL, &["forces.vorticity_m_s=0.01"]);
    let count = case.count();
    // Every kind in every component, of particles all over the pool.
    let bad = |id: usize| (id % 27 == 13 && id / 27 < 36).then_some(id / 27);
    case.place(|id, position_m, velocity_m_s| {
        if let Some(which) = bad(id) {
            let value = not_finite()[which / 6];
            match which % 6 {
                axis @ 0..3 => position_m[axis] = value,
                axis => velocity_m_s[axis - 3] = value,
            }
        }
    });
    let stats = case.run(1);
    assert_eq!((stats.quarantined, stats.particles as usize), (36, count - 36));
    // Where they were is room: the others fall a little.
    assert!(stats.max_speed_m_s < 0.5, "{} m/s in the first step", stats.max_speed_m_s);
    let stats = case.recovers(2.0);
    assert_eq!((stats.quarantined, stats.particles as usize), (36, count - 36));
    let state = case.state();
    for id in 0..count {
        assert_eq!(state.quarantined[id], bad(id).is_some(), "particle {id}");
    }
    println!("case 17: 36 of {count} quarantined, the others at rest: {:?}", stats.compression);
}

#[test]
fn absurd_but_finite_values_are_brought_back() {
    for (value, what) in [(3.0e38_f32, "position"), (-3.0e38, "position"), (3.0e38, "velocity"), (1.0e19, "velocity")] {
        let mut case = Case::new(POOL, &[]);
        let count = case.count();
        case.place(|id, position_m, velocity_m_s| {
            if id == 500 {
                if what == "position" { position_m[1] = value } else { velocity_m_s[1] = value }
            }
        });
        let stats = case.run(4);
        println!("case 17: a {what} of {value:e}: {} quarantined, {:?}", stats.quarantined, stats.counters);
        let stats = case.recovers(2.0);
        assert_eq!((stats.quarantined, stats.particles as usize), (0, count), "a {what} of {value:e}");
    }
}
