//! Where diffuse particles stand.

use std::mem::offset_of;

use brooklet_gpu::{DrawState, Recording, Targets};
use brooklet_kernels::{Buffer, DiffuseParticle, DiffuseState, Draw};

/// The slots of diffuse particles.
pub struct DiffuseSlots {
    /// What stands in them.
    pub particles: Buffer<DiffuseParticle>,
    /// Which of them are in use.
    pub state: Buffer<DiffuseState>,
}

impl DiffuseSlots {
    /// The same slots, for another owner.
    pub fn alias(&self) -> Self {
        Self { particles: self.particles.alias(), state: self.state.alias() }
    }

    /// Draws a triangle for each slot in use.
    pub fn draw<D: Draw>(&self, recording: &mut Recording, draw: &D, targets: &Targets<'_>, state: DrawState) {
        let offset = offset_of!(DiffuseState, vertex_count) as u32;
        recording.draw_indirect(draw, targets, state, &self.state, offset, self.particles.len);
    }
}
