//! The particles of a plan.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, Position, Velocity};

use crate::slots::Slots;

/// The particles between two substeps.
pub struct Particles {
    /// Where they are, relative to the domain's lowest corner.
    pub positions: Buffer<Position>,
    /// How fast they are, in the same order.
    pub velocities: Buffer<Velocity>,
}

impl Particles {
    /// Declares `count` particles.
    pub fn declare(resources: &mut Resources, count: u32) -> Self {
        Self {
            positions: resources.persistent("positions", count),
            velocities: resources.persistent("velocities", count),
        }
    }

    /// After a sort: what stands here is not read until all of it is written, from the sorted particles. Where the
    /// number of slots that are visited varies, those beyond it keep their ids.
    pub fn forget_until_moved(&self, recording: &mut Recording, slots: &Slots) {
        if slots.are_all_visited() {
            recording.forget(&self.positions);
            recording.forget(&self.velocities);
        }
    }
}
