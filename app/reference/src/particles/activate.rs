//! Particles in slots that were inactive. (Shader: `particles/activate.compute`.)

use glam::{DVec3, UVec3};

/// A block of particles; see `ActivateParams` of the shaders' layout.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    /// The particle at its lowest corner.
    pub first_m: DVec3,
    /// From one to the next, m.
    pub spacing_m: f64,
    /// Particles along each axis.
    pub counts: UVec3,
}

/// Where the block's particles go and stand: slot and position, x fastest, as many as find one of `capacity` slots
/// behind the first `active_count`.
pub fn activate_particles(block: &Block, active_count: u32, capacity: u32) -> Vec<(u32, DVec3)> {
    let [nx, ny, nz] = block.counts.to_array();
    let lattice =
        (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| DVec3::new(x.into(), y.into(), z.into()))));
    let at = |cell: DVec3| block.first_m + block.spacing_m * cell;
    (active_count..capacity).zip(lattice.map(at)).collect()
}

/// How many slots the block takes, and how many particles find none.
pub fn claim_slots(block: &Block, active_count: u32, capacity: u32) -> (u32, u32) {
    let claimed = activate_particles(block, active_count, capacity).len() as u32;
    (claimed, block.counts.element_product() - claimed)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: Block = Block { first_m: DVec3::ONE, spacing_m: 0.5, counts: UVec3::new(2, 1, 2) };

    #[test]
    fn x_is_fastest_and_slots_run_out() {
        let [a, b, c, d] = [[1.0, 1.0, 1.0], [1.5, 1.0, 1.0], [1.0, 1.0, 1.5], [1.5, 1.0, 1.5]].map(DVec3::from_array);
        assert_eq!(activate_particles(&BLOCK, 7, 100), [(7, a), (8, b), (9, c), (10, d)]);
        assert_eq!(activate_particles(&BLOCK, 7, 9), [(7, a), (8, b)]);
        assert_eq!(claim_slots(&BLOCK, 7, 9), (2, 2));
        assert_eq!(claim_slots(&BLOCK, 9, 9), (0, 4));
        assert_eq!(claim_slots(&Block { counts: UVec3::ZERO, ..BLOCK }, 0, 9), (0, 0));
    }
}
