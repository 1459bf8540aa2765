//! Spray, foam and bubbles on the host: what lasts of them from step to step.

use brooklet_gpu::group_grid;
use brooklet_kernels::{AdvectDiffuse, DiffuseParticle, DiffuseState, Kernel as _};

/// All diffuse particles of a scene; empty where it has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DiffuseSet {
    /// As they stand in the slots in use, relative to the domain's lowest corner; a lifetime of 0 is an empty slot.
    pub particles: Vec<DiffuseParticle>,
    /// The slot that the next one takes: behind the last, or, in a ring that is full, the oldest's.
    pub next_slot: u32,
}

impl DiffuseSet {
    /// As they stand in a ring of `capacity` slots: where they are if it is theirs or they have not filled it, else from
    /// the oldest on, of which those go that have no room.
    pub(super) fn in_ring(&self, capacity: u32) -> Self {
        let count = self.particles.len() as u32;
        if count == capacity || (count < capacity && self.next_slot == count) {
            return self.clone();
        }
        let mut particles = self.particles.clone();
        particles.rotate_left(self.next_slot.min(count) as usize);
        particles.drain(..count.saturating_sub(capacity) as usize);
        let next_slot = particles.len() as u32 % capacity.max(1);
        Self { particles, next_slot }
    }
}

/// What the GPU knows of so many slots in use.
pub(super) fn slots_in_use(count: u32, next_slot: u32) -> DiffuseState {
    DiffuseState {
        groups: group_grid(count.div_ceil(AdvectDiffuse::GROUP_SIZE[0])),
        next_slot,
        vertex_count: 3,
        instance_count: count,
        ..DiffuseState::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(lifetimes: &[u32], next_slot: u32) -> DiffuseSet {
        let of = |&k: &u32| DiffuseParticle { lifetime_s: k as f32, ..DiffuseParticle::default() };
        DiffuseSet { particles: lifetimes.iter().map(of).collect(), next_slot }
    }

    #[test]
    fn a_ring_of_another_size_keeps_the_youngest() {
        // Oldest first: 1, 2, 3, ...
        for (from, capacity, expected) in [
            (set(&[1, 2, 3], 3), 5, set(&[1, 2, 3], 3)),
            (set(&[1, 2, 3], 0), 3, set(&[1, 2, 3], 0)),
            (set(&[4, 5, 3], 2), 3, set(&[4, 5, 3], 2)),
            (set(&[4, 5, 3], 2), 5, set(&[3, 4, 5], 3)),
            (set(&[4, 5, 3], 2), 2, set(&[4, 5], 0)),
            (set(&[1, 2, 3], 3), 2, set(&[2, 3], 0)),
            (set(&[1, 2, 3], 3), 0, set(&[], 0)),
            (set(&[], 0), 4, set(&[], 0)),
        ] {
            assert_eq!(from.in_ring(capacity), expected, "{from:?} in {capacity}");
        }
    }

    #[test]
    fn the_state_is_the_one_that_settle_diffuse_leaves() {
        let state = slots_in_use(65, 65);
        assert_eq!((state.groups, state.vertex_count, state.instance_count), ([2, 1, 1], 3, 65));
    }
}
