//! Cases 4 and 5: more neighbours than a list holds, and each capacity of the program one below,
//! at and one above what it holds.

use brooklet_fluid::Scene;
use brooklet_reference::grid::list_neighbours::list_neighbours;
use brooklet_tests::extreme::Case;
use brooklet_tests::rng;
use glam::DVec3;
use rand::RngExt;

/// A cube of particles in open space without gravity.
fn cloud(side: usize) -> String {
    let high = 0.2 + 0.02 * side as f64;
    format!(
        "spacing_m = 0.02\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [0.6, 0.6, 0.6]\nwalls = false\n\
         [[fluid]]\nblock = {{ min_m = [0.2, 0.2, 0.2], max_m = [{high}, {high}, {high}] }}\n\
         [outputs]\nmeasure_every_steps = 1\n"
    )
}

/// Squeezes the cloud to 0.85 of its size, a little off the lattice.
fn squeeze(case: &mut Case) {
    let mut rng = rng(4);
    case.place(|_, position_m, _| {
        for x in position_m {
            *x = 0.2 + 0.85 * (*x - 0.2) + 0.002 * (rng.random::<f32>() - 0.5);
        }
    });
}

/// How many neighbours beyond `slots` the particles have, with distances of nearly h counted and not.
fn without_slot(at_m: &[DVec3], slots: usize) -> [u64; 2] {
    [1.0 - 1.0e-5, 1.0 + 1.0e-5].map(|doubt| {
        let lists = list_neighbours(at_m, |_| false, 0.04 * doubt);
        lists.iter().map(|list| list.len().saturating_sub(slots) as u64).sum()
    })
}

/// Sum of the velocities over the sum of their lengths.
fn drift(case: &mut Case) -> f64 {
    let velocities = case.state().velocities_m_s();
    velocities.iter().sum::<DVec3>().length() / velocities.iter().map(|v| v.length()).sum::<f64>()
}

/// A support of 3 spacings holds 122 lattice points: 48 slots would lose half of them, of one in a pair or the other.
#[test]
fn a_wide_support_has_room_by_default() {
    let dam = "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [0.4, 0.4, 0.16]\n\
         [[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [0.2, 0.24, 0.16] }\n\
         [outputs]\nmeasure_every_steps = 1\n";
    let overflow = |settings: &[&str]| {
        let counters = Case::new(dam, settings).run(120).counters;
        println!("{settings:?}: {counters:?}");
        counters.neighbour_overflow
    };
    assert_eq!(overflow(&["solver.support_ratio=3"]), 0);
    assert_eq!(overflow(&["solver.support_ratio=2.5"]), 0);
    assert!(overflow(&["solver.support_ratio=3", "solver.neighbour_slots=48"]) > 0);
}

#[test]
fn neighbours_beyond_the_slots_are_counted_and_the_drift_is_known() {
    let mut drifts = Vec::new();
    for slots in [48, 160] {
        let slots_setting = format!("solver.neighbour_slots={slots}");
        let mut case = Case::new(&cloud(8), &[&slots_setting]);
        squeeze(&mut case);
        let expected = without_slot(&case.state().at_m(), slots);
        let stats = case.run(1);
        let counted = u64::from(stats.counters.neighbour_overflow);
        assert!(expected[0] <= counted && counted <= expected[1], "counted {counted}, expected {expected:?}");
        assert_eq!(counted > 0, slots == 48);
        drifts.push(drift(&mut case));
        println!(
            "case 4: {slots} slots: {counted} neighbours had none; momentum drift {:.1e} of what moves, {:?}",
            drifts[drifts.len() - 1],
            stats.counters
        );
        // The cloud flies apart: it recovers when nothing is pushed any more.
        case.run(40);
        let stats = case.run(20);
        assert_eq!(stats.counters.neighbour_overflow, 0);
        println!("capacity: {:?}", stats.compression);
        assert!(stats.compression.max < 1.0e-3, "{:?}", stats.compression);
    }
    // Whose lists are whole push each other equally, up to rounding; others do not, and are told.
    assert!(drifts[1] < 1.0e-5, "{drifts:?}");
    assert!(drifts[0] > 10.0 * drifts[1] && drifts[0] < 0.5, "{drifts:?}");
}

#[test]
fn lists_hold_their_slots_and_no_more() {
    let slots = 16;
    for (count, overflow) in [(slots, 0), (slots + 1, 0), (slots + 2, slots + 2)] {
        let mut case = Case::new(&cloud(3), &["solver.neighbour_slots=16", "solver.pbf.iterations=0", "forces.xsph=0"]);
        let mut rng = rng(5);
        // `count` particles within h of each other; the others far from them and from one another.
        case.place(|id, position_m, _| {
            *position_m = match id < count {
                true => [0; 3].map(|_| 0.3 + 0.02 * rng.random::<f32>()),
                false => [0.05 * (id - count) as f32, 0.1, 0.1],
            }
        });
        let stats = case.run(1);
        assert_eq!(stats.counters.neighbour_overflow as usize, overflow, "{count} particles, {slots} slots each");
        println!("case 5: {} neighbours, {slots} slots: {overflow} without a slot", count - 1);
    }
}

/// Blocks of so many particles, side by side. The spacing is a power of two, so that sums are exact.
fn blocks(counts: &[[u32; 3]]) -> Result<Scene, String> {
    let spacing_m = 0.015625;
    let mut text = format!("spacing_m = {spacing_m}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [4.5, 4, 4]\n");
    let mut first_m = 0.0;
    for count in counts {
        let [x, y, z] = count.map(|n| f64::from(n) * spacing_m);
        let last_m = first_m + x;
        text += &format!("[[fluid]]\nblock = {{ min_m = [{first_m}, 0, 0], max_m = [{last_m}, {y}, {z}] }}\n");
        first_m = last_m;
    }
    Scene::from_toml(&text, "blocks.toml", &[]).map_err(|error| error.to_string())
}

#[test]
fn ids_run_out_after_two_to_the_24() {
    // 24 bits of a tag are the id. The scenes are only read: their memory is no test's to take.
    blocks(&[[255, 256, 256], [1, 255, 256], [1, 1, 255]]).unwrap();
    blocks(&[[256, 256, 256]]).unwrap();
    let message = blocks(&[[256, 256, 256], [1, 1, 1]]).unwrap_err();
    println!("case 5: {message}");
    assert!(message.contains("16777216"), "{message}");
}
