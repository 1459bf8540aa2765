//! Particles of a case, and a picture of them as the product records it.

use crate::wrong::OrRaise as _;
use brooklet_fluid::{Slots, visit_slots};
use brooklet_gpu::Resources;
use brooklet_kernels::Position;
use brooklet_render::frame::{self, FramePasses};
use brooklet_render::{FrameOptions, Particles, View};

/// Records how particles at rest are drawn; the picture's `init` puts them where they are.
pub(crate) fn record_frame(view: &View, options: &FrameOptions, positions: &[Position]) -> (Resources, FramePasses) {
    let count = positions.len() as u32;
    let mut resources = Resources::new();
    let mut buffer = resources.persistent::<Position>("positions", count);
    let velocities = resources.persistent("velocities", count);
    let mut slots = Slots::declare(&mut resources, count);
    let particles = Particles {
        positions: &buffer,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let mut passes = frame::record(&mut resources, view, &particles, options).or_raise();
    passes.init.upload(&mut slots.state, &[visit_slots(count)]);
    if count > 0 {
        passes.init.upload(&mut buffer, positions);
    }
    (resources, passes)
}
