//! What bounds the fluid, as solvers and measures ask it. (Shader: `boundary/boundary.hlsli`.) Walls are the first
//! answer.

pub mod wall_integrals;
pub mod walls;

use glam::DVec3;

/// What a boundary answers at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundarySample {
    /// The density ratio that it adds.
    pub density: f64,
    /// The gradient of that by position, per h.
    pub gradient: DVec3,
    /// What the fluid's own correction is multiplied by along each axis.
    pub correction_scale: DVec3,
}
