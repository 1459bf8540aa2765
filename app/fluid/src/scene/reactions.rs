//! Which solids are told what particles take from them: bodies, which it moves, then those whose force is measured.

use brooklet_kernels::NO_BODY;

use super::Scene;

/// How many of the solids are bodies.
pub fn body_count(scene: &Scene) -> u32 {
    scene.solids.iter().filter(|solid| solid.density_kg_m3.is_some()).count() as u32
}

/// The solids whose force is measured, by their places among all.
pub fn measured_solids(scene: &Scene) -> impl Iterator<Item = usize> {
    let solids = scene.solids.iter().enumerate();
    solids.filter(|(_, solid)| solid.measure_force && solid.density_kg_m3.is_none()).map(|(index, _)| index)
}

/// How many of the solids have a reaction.
pub fn reaction_count(scene: &Scene) -> u32 {
    body_count(scene) + measured_solids(scene).count() as u32
}

/// Each solid's place among the reactions, or that it has none ([`NO_BODY`]).
pub(super) fn reaction_places(scene: &Scene) -> Vec<u32> {
    let mut places = vec![NO_BODY; scene.solids.len()];
    let bodies = (0..scene.solids.len()).filter(|&index| scene.solids[index].density_kg_m3.is_some());
    for (place, index) in (0..).zip(bodies.chain(measured_solids(scene))) {
        places[index] = place;
    }
    places
}
