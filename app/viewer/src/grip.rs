//! A body that a hand holds: by which point, and where that is to be.

use brooklet_fluid::drag_body::BodyDrag;
use brooklet_render::View;
use glam::DVec3;

use crate::orbit::ray;
use crate::pick::Hit;
use crate::pointer::Pointing;

/// The body in a hand.
#[derive(Clone, Copy, Debug, Default)]
pub struct GripInput {
    held: Option<Held>,
    is_let_go: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Held {
    body: u32,
    solid: usize,
    in_frame_m: DVec3,
    /// Where it was grasped: the hand moves in the plane through this that faces the camera.
    grasped_m: DVec3,
    target_m: DVec3,
}

/// A drag of a body that waits for the simulation to go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PendingGrip {
    body: u32,
    in_frame_m: DVec3,
    target_m: DVec3,
}

/// Time in which a body comes to the hand: to 2/e of the way.
const TAU_S: f64 = 0.03;
/// As fast as the fluid that a hand drags, at most.
const MOST_M_S: f64 = 4.0;

impl GripInput {
    /// Follows the pointer in a view; `pick` says what is under a place of the picture. What is held, if it is a body.
    pub fn follow(
        &mut self,
        pointing: &Pointing,
        view: &View,
        pick: impl FnOnce(glam::DVec2) -> Option<Hit>,
    ) -> Option<PendingGrip> {
        if let Some(at) = pointing.pressed {
            self.is_let_go = false;
            self.held = pick(at).and_then(|hit| {
                let of = |body| Held {
                    body,
                    solid: hit.solid,
                    in_frame_m: hit.in_frame_m,
                    grasped_m: hit.at_m,
                    target_m: hit.at_m,
                };
                hit.body.map(of)
            });
        }
        let held = self.held.as_mut()?;
        if let Some(at) = pointing.main_at.filter(|_| !self.is_let_go) {
            held.target_m = target_m(view, at, held.grasped_m).unwrap_or(held.target_m);
        }
        // Let go before the simulation had time for it: the drag waits.
        self.is_let_go |= !pointing.is_held;
        Some(PendingGrip { body: held.body, in_frame_m: held.in_frame_m, target_m: held.target_m })
    }

    /// The simulation went on, or never will: what was let go is free.
    pub fn restart(&mut self) {
        if self.is_let_go {
            self.held = None;
        }
    }

    /// Lets go: another scene has other bodies.
    pub fn let_go(&mut self) {
        *self = Self::default();
    }

    /// Which solid is held, by which point of its frame, and where that is to be.
    pub fn tether(&self) -> Option<(usize, DVec3, DVec3)> {
        self.held.map(|held| (held.solid, held.in_frame_m, held.target_m))
    }
}

/// Where a place of the picture is in the plane through `grasped_m` that faces the camera, within the domain.
fn target_m(view: &View, at: glam::DVec2, grasped_m: DVec3) -> Option<DVec3> {
    let ray = ray(view, at);
    let forward = -view.camera.axes().z_axis;
    let origin_m = ray.origin_m - view.domain_min_m;
    let along_m = (grasped_m - origin_m).dot(forward) / ray.direction.dot(forward);
    let target_m = origin_m + along_m * ray.direction;
    target_m.is_finite().then(|| target_m.clamp(DVec3::ZERO, view.domain_max_m - view.domain_min_m))
}

impl PendingGrip {
    /// The drag in a frame that advances by so much.
    pub fn over(&self, advance_s: f64) -> BodyDrag {
        BodyDrag {
            body: self.body,
            grip_m: self.in_frame_m.to_array(),
            target_m: self.target_m.to_array(),
            dt_s: advance_s,
            tau_s: TAU_S,
            most_m_s: MOST_M_S,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_render::Camera;
    use glam::DVec2;

    fn view() -> View {
        View {
            camera: Camera { eye_m: DVec3::new(1.5, 0.5, 4.0), target_m: DVec3::new(1.5, 0.5, 0.5), fov_deg: 40.0 },
            domain_min_m: DVec3::new(1.0, 0.0, 0.0),
            domain_max_m: DVec3::new(2.0, 1.0, 1.0),
            size_px: [400, 400],
        }
    }

    fn body(_: DVec2) -> Option<Hit> {
        let at_m = DVec3::new(0.5, 0.5, 0.5);
        Some(Hit { solid: 3, body: Some(1), at_m, in_frame_m: DVec3::X, normal: DVec3::Z, distance_m: 3.5 })
    }

    fn pointing(pressed: Option<DVec2>, main_at: DVec2, is_held: bool) -> Pointing {
        Pointing { pressed, main_at: Some(main_at), is_held, ..Pointing::default() }
    }

    #[test]
    fn a_body_follows_the_hand_in_the_plane_where_it_was_grasped() {
        let (mut input, middle) = (GripInput::default(), DVec2::splat(0.5));
        let still = input.follow(&pointing(Some(middle), middle, true), &view(), body).unwrap();
        assert_eq!((still.body, still.target_m), (1, DVec3::splat(0.5)), "relative to the domain");
        let moved = input.follow(&pointing(None, DVec2::new(0.6, 0.4), true), &view(), |_| None).unwrap();
        let height_m = 2.0 * 3.5 * 20f64.to_radians().tan();
        let expected_m = DVec3::splat(0.5) + 0.1 * height_m * DVec3::new(1.0, 1.0, 0.0);
        assert!(moved.target_m.abs_diff_eq(expected_m, 1e-9), "{moved:?}");
        // Out of the domain it is at its wall; it stays there while the hand is still, and the simulation goes on.
        input.restart();
        let out = input.follow(&pointing(None, DVec2::new(1.0, 0.5), true), &view(), |_| None).unwrap();
        assert_eq!(out.target_m.x, 1.0);
        let drag = out.over(0.01);
        assert_eq!((drag.body, drag.grip_m, drag.dt_s), (1, [1.0, 0.0, 0.0], 0.01));
    }

    #[test]
    fn what_is_let_go_moves_once_more_and_is_free() {
        let (mut input, middle) = (GripInput::default(), DVec2::splat(0.5));
        // Down, aside and up between two frames.
        let flick = pointing(Some(middle), DVec2::new(0.7, 0.5), false);
        let moved = input.follow(&flick, &view(), body).unwrap();
        assert!(moved.target_m.x > 0.6);
        assert_eq!(input.follow(&Pointing::default(), &view(), |_| None), Some(moved), "it waits for its time");
        assert_eq!(input.tether(), Some((3, DVec3::X, moved.target_m)));
        input.restart();
        assert_eq!(input.follow(&Pointing::default(), &view(), |_| None), None);
        // What is no body, or nothing, is not held.
        let fixed = |at| body(at).map(|hit| Hit { body: None, ..hit });
        assert_eq!(input.follow(&pointing(Some(middle), middle, true), &view(), fixed), None);
        assert_eq!(input.follow(&pointing(Some(middle), middle, true), &view(), |_| None), None);
    }
}
