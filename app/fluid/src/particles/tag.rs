//! What a particle's tag says. (Shader: `shared/tag.hlsli`.)

use brooklet_kernels::{FLUID_SHIFT, INACTIVE_FLUID, QUARANTINED};

/// The particle's id.
pub fn id_of(tag: u32) -> u32 {
    tag & ((1 << FLUID_SHIFT) - 1)
}

/// The number of its fluid.
pub fn fluid_of(tag: u32) -> u32 {
    tag >> FLUID_SHIFT & INACTIVE_FLUID
}

/// Whether the particle's state was not finite.
pub fn is_quarantined(tag: u32) -> bool {
    tag & QUARANTINED != 0
}

/// Whether the slot holds no particle.
pub fn is_inactive(tag: u32) -> bool {
    fluid_of(tag) == INACTIVE_FLUID
}

/// Whether the slot holds a particle that takes part.
pub fn is_simulated(tag: u32) -> bool {
    !is_quarantined(tag) && !is_inactive(tag)
}
