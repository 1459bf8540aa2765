//! What bounds the fluid, as solvers and measures ask it. (Shader: `boundary/boundary.hlsli`.) Walls are the first
//! answer; in an open domain nothing is added, scaled or confined.

pub mod bodies;
pub mod drag_walls;
pub mod mirror;
pub mod repel_walls;
pub mod solids;
pub mod wall_integrals;
pub mod walls;

use crate::params::Step;
use glam::DVec3;
use walls::DomainWalls;

/// What a boundary answers at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundarySample {
    /// The density ratio that it adds.
    pub density: f64,
    /// The gradient of that by position, per h.
    pub gradient: DVec3,
    /// What the fluid's own correction is multiplied by along each axis.
    pub correction_scale: DVec3,
    /// What it bears of the fluid's weight along each axis, where pressure goes on beyond as in fluid at rest.
    pub borne: DVec3,
}

/// What the boundary answers at a position; `walls` is `None` in an open domain.
pub fn sample_boundary(position_m: DVec3, walls: Option<&DomainWalls>) -> BoundarySample {
    let open = BoundarySample { density: 0.0, gradient: DVec3::ZERO, correction_scale: DVec3::ONE, borne: DVec3::ZERO };
    walls.map_or(open, |walls| walls.sample(position_m))
}

/// The position, moved to where the boundary lets a particle be.
pub fn confine_position(position_m: DVec3, step: &Step) -> DVec3 {
    let low_m = DVec3::splat(step.wall_offset_m);
    DVec3::select(step.walls, position_m.clamp(low_m, step.domain_size_m - low_m), position_m)
}

/// The end of a free path and the velocity along it, after an inelastic contact: what the boundary takes of the path
/// it takes of the velocity.
pub fn confine_path(position_m: DVec3, velocity_m_s: DVec3, step: &Step) -> (DVec3, DVec3) {
    if !step.walls.any() {
        return (position_m, velocity_m_s);
    }
    let inside_m = confine_position(position_m, step);
    let fastest_m_s = DVec3::splat(step.max_speed_m_s);
    (inside_m, (velocity_m_s + (inside_m - position_m) / step.dt_s).clamp(-fastest_m_s, fastest_m_s))
}

/// The end of a free path and the velocity along it, after a bounce that gives back the share `restitution` of the
/// speed across the boundary.
pub fn bounce_path(position_m: DVec3, mut velocity_m_s: DVec3, restitution: f64, step: &Step) -> (DVec3, DVec3) {
    let inside_m = confine_position(position_m, step);
    let beyond_m = position_m - inside_m;
    for axis in 0..3 {
        if beyond_m[axis] * velocity_m_s[axis] > 0.0 {
            velocity_m_s[axis] *= -restitution;
        }
    }
    (confine_position(inside_m - restitution * beyond_m, step), velocity_m_s)
}
