//! A body is drawn by a point of it to a place. (Shader: `boundary/bodies/drag_body.compute`.)

use glam::{DMat3, DVec3};

use super::{Body, BodyState};

/// How a body is dragged.
#[derive(Clone, Copy, Debug)]
pub struct BodyDrag {
    /// The point, in its solid's frame.
    pub grip_m: DVec3,
    /// Where that is drawn to.
    pub target_m: DVec3,
    /// Share of the point's velocity that is left.
    pub kept: f64,
    /// Of the way to the target.
    pub pull_per_s: f64,
    /// Share of the body's spin that is left.
    pub kept_spin: f64,
    /// The point is made no faster.
    pub most_m_s: f64,
}

/// Where the point is.
pub fn grip_m(body: &Body, state: &BodyState, drag: &BodyDrag) -> DVec3 {
    state.position_m + state.rotation * (drag.grip_m - body.centre_of_mass_m)
}

/// The body after the drag.
pub fn drag_body(body: &Body, state: &BodyState, drag: &BodyDrag) -> BodyState {
    let grip_m = grip_m(body, state, drag);
    let arm_m = grip_m - state.position_m;
    let before_m_s = state.velocity_at(grip_m);
    let wanted_m_s =
        (drag.kept * before_m_s + drag.pull_per_s * (drag.target_m - grip_m)).clamp_length_max(drag.most_m_s);
    if let Some(hinge) = body.hinge {
        let along = hinge.axis.cross(grip_m - hinge.at_m);
        let gained_rad_s = (wanted_m_s - before_m_s).dot(along) / along.length_squared();
        let spin_rad_s = drag.kept_spin * (state.spin_rad_s + gained_rad_s * hinge.axis);
        let velocity_m_s = spin_rad_s.cross(state.position_m - hinge.at_m);
        return BodyState { velocity_m_s, spin_rad_s, ..*state };
    }
    let frame = DMat3::from_quat(state.rotation);
    let inverse_inertia = frame * body.inertia_kg_m2.inverse() * frame.transpose();
    let across = DMat3::from_cols(arm_m.cross(DVec3::X), arm_m.cross(DVec3::Y), arm_m.cross(DVec3::Z));
    let mobility = DMat3::from_diagonal(DVec3::splat(body.mass_kg.recip())) - across * inverse_inertia * across;
    let impulse_kg_m_s = mobility.inverse() * (wanted_m_s - before_m_s);
    BodyState {
        velocity_m_s: state.velocity_m_s + impulse_kg_m_s / body.mass_kg,
        spin_rad_s: drag.kept_spin * (state.spin_rad_s + inverse_inertia * arm_m.cross(impulse_kg_m_s)),
        ..*state
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    #[test]
    fn the_grip_has_the_velocity_that_is_wanted() {
        let body = Body {
            centre_of_mass_m: DVec3::new(0.0, -0.02, 0.01),
            mass_kg: 3.0,
            inertia_kg_m2: DMat3::from_diagonal(DVec3::new(0.02, 0.05, 0.04)),
            added_mass_kg: 1.0,
            added_inertia_kg_m2: DMat3::ZERO,
            wet_per_push: 0.1,
            hinge: None,
        };
        let state = BodyState {
            position_m: DVec3::new(0.4, 0.5, 0.6),
            rotation: DQuat::from_scaled_axis(DVec3::new(0.3, -1.0, 0.4)),
            velocity_m_s: DVec3::new(0.5, 0.2, -0.1),
            spin_rad_s: DVec3::new(1.0, -2.0, 3.0),
            owed_kg_m_s: DVec3::ZERO,
            owed_kg_m2_s: DVec3::ZERO,
        };
        let drag = BodyDrag {
            grip_m: DVec3::new(0.1, 0.03, -0.05),
            target_m: DVec3::new(0.5, 0.6, 0.6),
            kept: 0.7,
            pull_per_s: 2.0,
            kept_spin: 1.0,
            most_m_s: 4.0,
        };
        let at_m = grip_m(&body, &state, &drag);
        let wanted_m_s = 0.7 * state.velocity_at(at_m) + 2.0 * (drag.target_m - at_m);
        let after = drag_body(&body, &state, &drag);
        assert!(after.velocity_at(at_m).abs_diff_eq(wanted_m_s, 1e-12), "{after:?}");
        assert_eq!((after.position_m, after.rotation), (state.position_m, state.rotation));
        // No faster than allowed, and what is let alone goes on.
        let slow = drag_body(&body, &state, &BodyDrag { most_m_s: 0.1, ..drag });
        assert!((slow.velocity_at(at_m).length() - 0.1).abs() < 1e-12);
        let idle = drag_body(&body, &state, &BodyDrag { kept: 1.0, pull_per_s: 0.0, ..drag });
        assert!(idle.velocity_m_s.abs_diff_eq(state.velocity_m_s, 1e-12));
    }
}
