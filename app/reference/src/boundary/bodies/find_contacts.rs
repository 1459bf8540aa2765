//! What a point of a body touches, or may touch in a substep. (Shader: `boundary/bodies/find_contacts.compute`.)

use super::{BodyContact, BodyState};
use crate::boundary::solids::{Pose, Solid};
use glam::DVec3;

/// A point of a body's surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint {
    /// Where it is, m.
    pub at_m: DVec3,
    /// Of the ball around it, m.
    pub radius_m: f64,
    /// Whose it is.
    pub body: usize,
    /// That body's solid.
    pub solid: usize,
}

/// A solid, where it is, where it was a substep before, and which body it is.
#[derive(Clone, Debug)]
pub struct Other {
    /// Its shape.
    pub solid: Solid,
    /// Where it is.
    pub pose: Pose,
    /// Where it was.
    pub before: Pose,
    /// Which body it is, if one.
    pub body: Option<usize>,
    /// Of contacts with it.
    pub friction: f64,
    /// Of contacts with it.
    pub restitution: f64,
}

/// Everything that the point is near enough to, walls first, in any number, each with how far it is within reach, m.
pub fn contacts_of(
    point: &SurfacePoint,
    state: &BodyState,
    others: &[Other],
    walls_m: [DVec3; 2],
    stop_m: f64,
    dt_s: f64,
) -> Vec<(BodyContact, f64)> {
    let own = &others[point.solid];
    let velocity_m_s = state.velocity_at(point.at_m);
    let mut found = Vec::new();
    let mut add = |contact: BodyContact, relative_m_s: DVec3| {
        let within_m = stop_m + 2.0 * dt_s * (-relative_m_s.dot(contact.normal)).max(0.0) - contact.gap_m;
        found.push((contact, within_m));
    };
    for face in 0..6 {
        let (axis, side) = (face / 2, if face % 2 == 0 { 1.0 } else { -1.0 });
        let mut normal = DVec3::ZERO;
        normal[axis] = side;
        let gap_m = side * (point.at_m[axis] - walls_m[face % 2][axis]) - point.radius_m;
        let contact = BodyContact {
            at_m: point.at_m - normal * (gap_m + point.radius_m),
            gap_m,
            normal,
            body: point.body,
            other: None,
            other_m_s: DVec3::ZERO,
            friction: own.friction,
            restitution: own.restitution,
        };
        add(contact, velocity_m_s);
    }
    for other in others[..point.solid].iter().chain(&others[point.solid + 1..]) {
        let (distance_m, out) = other.solid.surface(other.pose.in_frame(point.at_m));
        let normal = other.pose.rotation * out;
        let at_m = point.at_m - normal * distance_m;
        let other_m_s = (at_m - other.before.from_frame(other.pose.in_frame(at_m))) / dt_s;
        let contact = BodyContact {
            at_m,
            gap_m: distance_m - point.radius_m,
            normal,
            body: point.body,
            other: other.body,
            other_m_s,
            friction: 0.5 * (own.friction + other.friction),
            restitution: own.restitution.max(other.restitution),
        };
        add(contact, velocity_m_s - other_m_s);
    }
    found
}
