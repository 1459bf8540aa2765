//! Which solids are told what particles take from them: bodies, which it moves, then those whose force is measured.

use brooklet_kernels::NO_BODY;

use super::Scene;

/// The solids that are bodies, by their places among all.
fn body_places(scene: &Scene) -> impl Iterator<Item = usize> {
    (0..scene.solids.len()).filter(|&index| scene.solids[index].density_kg_m3.is_some())
}

/// The solids whose force is measured, likewise; none is a body.
pub fn measured_solids(scene: &Scene) -> impl Iterator<Item = usize> {
    (0..scene.solids.len()).filter(|&index| scene.solids[index].measure_force)
}

/// How many of the solids are bodies.
pub fn body_count(scene: &Scene) -> u32 {
    body_places(scene).count() as u32
}

/// How many of the solids have a reaction.
pub fn reaction_count(scene: &Scene) -> u32 {
    body_count(scene) + measured_solids(scene).count() as u32
}

/// Each solid's place among the reactions, or that it has none ([`NO_BODY`]).
pub(super) fn reaction_places(scene: &Scene) -> Vec<u32> {
    let mut places = vec![NO_BODY; scene.solids.len()];
    for (place, index) in (0..).zip(body_places(scene).chain(measured_solids(scene))) {
        places[index] = place;
    }
    places
}
