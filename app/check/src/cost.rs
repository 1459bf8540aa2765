//! Which cases take long, for who has little time: first an answer of every stage, then all others, each from the cheapest on.

use std::collections::BTreeSet;

use crate::device::KnownAnswer;

/// Cases that take a second or more on two cores without a GPU where nothing is compiled yet (Mesa's lavapipe, small sizes),
/// with their seconds: some for their twin, some for what the driver compiles. A driver of a GPU is faster in both; their order
/// is what counts.
const SLOW: [(&str, &str, f64); 17] = [
    ("marching_cubes", "mark_blocks_lists_what_its_twin_lists", 1.0),
    ("list", "a_wrapped_grid_lists_what_a_dense_one_does", 1.1),
    ("pictures", "points_are_as_stored", 1.1),
    ("pictures", "water_is_as_stored", 1.1),
    ("scan", "scan_of_several_levels_matches_its_twin", 1.1),
    ("list", "lists_reach_over_escapes", 1.4),
    ("list", "periodic_lists_are_those_of_the_nearest_images", 1.6),
    ("refine", "subdivided_meshes_are_the_twin_s_and_closed", 1.7),
    ("solver", "correct_positions_matches_its_twin", 1.8),
    ("drawn_caustics", "each_stage_is_its_twin", 1.8),
    ("constrain_density", "momentum_matches_its_twin", 2.3),
    ("anisotropic_mesh", "the_mesh_of_ellipsoids_matches_its_twin", 3.4),
    ("boundary", "walls_match_their_twin", 3.7),
    ("drawn_thickness", "the_nearest_spheres_and_their_thickness_are_their_twins", 4.0),
    ("marching_cubes", "gather_field_matches_its_twin", 4.6),
    ("periodic", "densities_match_their_twins", 7.2),
    ("measure", "measures_match_their_twins", 10.5),
];
/// What one of the others takes, s, about.
const OTHERS_S: f64 = 0.2;

/// About how long a case takes, s, where the driver runs on the processor.
fn cost_s(known: &KnownAnswer) -> f64 {
    let listed = SLOW.iter().find(|(room, name, _)| (*room, *name) == (known.room, known.name));
    listed.map_or(OTHERS_S, |(_, _, seconds)| *seconds)
}

/// The same cases, for who may have to stop: those that are the first answer of a stage, then the rest, each from the cheapest
/// on. What is left out at the end are second answers before first ones.
pub(crate) fn cheapest_first(mut cases: Vec<&'static KnownAnswer>) -> Vec<&'static KnownAnswer> {
    cases.sort_by(|a, b| cost_s(a).total_cmp(&cost_s(b)));
    let mut answered = BTreeSet::<&str>::new();
    let is_first = |known: &&KnownAnswer| {
        let before = answered.len();
        answered.extend(known.stages);
        answered.len() > before
    };
    let (mut first, rest): (Vec<_>, Vec<_>) = cases.into_iter().partition(is_first);
    first.extend(rest);
    first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::KNOWN_ANSWERS;

    #[test]
    fn every_slow_case_is_one() {
        for (room, name, _) in SLOW {
            let count = KNOWN_ANSWERS.iter().filter(|known| (known.room, known.name) == (room, name)).count();
            assert_eq!(count, 1, "{room}: {name}");
        }
        assert!(SLOW.is_sorted_by(|a, b| a.2 <= b.2));
    }

    #[test]
    fn every_stage_has_an_answer_before_any_has_a_second_and_cheap_ones_come_first() {
        let ordered = cheapest_first(KNOWN_ANSWERS.iter().collect());
        let key = |known: &KnownAnswer| (known.room, known.name);
        let (mut all, mut same): (Vec<_>, Vec<_>) =
            (KNOWN_ANSWERS.iter().map(key).collect(), ordered.iter().map(|known| key(known)).collect());
        all.sort_unstable();
        same.sort_unstable();
        assert_eq!(all, same, "each once");
        let stages: BTreeSet<&str> = KNOWN_ANSWERS.iter().flat_map(|known| known.stages).copied().collect();
        let mut answered = BTreeSet::new();
        let firsts = ordered.iter().position(|known| {
            let before = answered.len();
            answered.extend(known.stages.iter().copied());
            answered.len() == before
        });
        let (first, rest) = ordered.split_at(firsts.unwrap());
        let reached: BTreeSet<&str> = first.iter().flat_map(|known| known.stages).copied().collect();
        assert_eq!(reached, stages);
        for part in [first, rest] {
            assert!(part.is_sorted_by(|a, b| cost_s(a) <= cost_s(b)));
        }
        assert!(!KNOWN_ANSWERS.is_sorted_by(|a, b| cost_s(a) <= cost_s(b)), "they are not so by themselves");
    }
}
