//! Where diffuse particles stand.

use std::mem::offset_of;

use brooklet_gpu::{DrawState, Engine, GpuError, Recording, Targets};
use brooklet_kernels::{Buffer, DiffuseParticle, DiffuseState, Draw};

use super::set::{DiffuseSet, slots_in_use};

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

    /// None of a plan in which nothing asks for them.
    pub(crate) fn read(&self, engine: &mut Engine) -> Result<DiffuseSet, GpuError> {
        if engine.wgpu_buffer(self.particles.id).is_none() {
            return Ok(DiffuseSet::default());
        }
        let state = engine.read(&self.state)?[0];
        let mut particles = engine.read(&self.particles)?;
        particles.truncate(state.instance_count as usize);
        Ok(DiffuseSet { particles, next_slot: state.next_slot })
    }

    /// The youngest of them where there is not room for all.
    pub(crate) fn write(&self, engine: &mut Engine, set: &DiffuseSet) {
        let DiffuseSet { mut particles, next_slot } = set.in_ring(self.particles.len);
        engine.write(&self.state, &[slots_in_use(particles.len() as u32, next_slot)]);
        // What stood in the other slots is over.
        particles.resize(self.particles.len as usize, DiffuseParticle::default());
        engine.write(&self.particles, &particles);
    }

    /// Draws a triangle for each slot in use.
    pub fn draw<D: Draw>(&self, recording: &mut Recording, draw: &D, targets: &Targets<'_>, state: DrawState) {
        let offset = offset_of!(DiffuseState, vertex_count) as u32;
        recording.draw_indirect(draw, targets, state, &self.state, offset, self.particles.len);
    }
}
