//! Dragging the fluid: what was dragged since the simulation last went on.

use brooklet_fluid::drag::Drag;
use brooklet_render::View;
use glam::{DVec2, DVec3};

use crate::orbit::ray;
use crate::pointer::Pointing;

/// What was dragged.
#[derive(Clone, Copy, Debug, Default)]
pub struct DragInput {
    at: DVec2,
    moved: DVec2,
}

/// A drag that waits for the simulation to go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PendingDrag {
    origin_m: DVec3,
    direction: DVec3,
    radius_m: f64,
    moved_m: DVec3,
}

/// How far the hand reaches, in diagonals of the domain.
const REACH_RATIO: f64 = 0.07;
/// Time in which the fluid under the hand comes within 1/e of its speed.
const TAU_S: f64 = 0.02;
/// What is dragged across the picture in one slow frame would be a shot otherwise.
const MOST_M_S: f64 = 4.0;

impl DragInput {
    /// What the pointer dragged in a view since the last restart, though it may be let go by now; nothing while
    /// it is still.
    pub fn pending(&mut self, pointing: &Pointing, view: &View) -> Option<PendingDrag> {
        if let Some((at, moved)) = pointing.drag {
            self.at = at;
            self.moved += moved;
        }
        if self.moved == DVec2::ZERO {
            return None;
        }
        let ray = ray(view, self.at);
        let axes = view.camera.axes();
        let height_m = 2.0 * (view.camera.eye_m - view.camera.target_m).length() * view.tan_half().y;
        Some(PendingDrag {
            origin_m: ray.origin_m - view.domain_min_m,
            direction: ray.direction,
            radius_m: REACH_RATIO * view.diagonal_m(),
            moved_m: height_m * (self.moved.x * axes.x_axis - self.moved.y * axes.y_axis),
        })
    }

    /// The simulation went on: what was dragged is done.
    pub fn restart(&mut self) {
        self.moved = DVec2::ZERO;
    }
}

impl PendingDrag {
    /// The drag in a frame that advances by so much. The hand's speed is that in simulated time: what is
    /// seen to move with the hand moves with it, in slow motion, too.
    pub fn over(&self, advance_s: f64) -> Drag {
        Drag {
            origin_m: self.origin_m.to_array(),
            direction: self.direction.to_array(),
            radius_m: self.radius_m,
            near_m: 0.0,
            far_m: f64::INFINITY,
            velocity_m_s: (self.moved_m / advance_s).clamp_length_max(MOST_M_S).to_array(),
            dt_s: advance_s,
            tau_s: TAU_S,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_render::Camera;

    fn view() -> View {
        View {
            camera: Camera { eye_m: DVec3::new(1.0, 0.5, 4.0), target_m: DVec3::new(1.0, 0.5, 0.5), fov_deg: 40.0 },
            domain_min_m: DVec3::new(1.0, 0.0, 0.0),
            domain_max_m: DVec3::new(2.0, 1.0, 1.0),
            size_px: [640, 360],
        }
    }

    #[test]
    fn the_fluid_goes_where_the_hand_goes() {
        let mut input = DragInput::default();
        let dragged =
            |x: f64, y: f64| Pointing { drag: Some((DVec2::splat(0.5), DVec2::new(x, y))), ..Pointing::default() };
        assert_eq!(input.pending(&Pointing::default(), &view()), None);
        assert_eq!(input.pending(&dragged(0.0, 0.0), &view()), None);
        // What is dragged while the simulation has no time adds up.
        input.pending(&dragged(0.01, 0.0), &view());
        input.pending(&dragged(0.01, -0.005), &view());
        // Let go before that: the drag waits.
        let pending = input.pending(&Pointing::default(), &view()).unwrap();
        let height_m = 2.0 * 3.5 * 20f64.to_radians().tan();
        assert!(pending.moved_m.abs_diff_eq(height_m * DVec3::new(0.02, 0.005, 0.0), 1e-12), "{pending:?}");
        let drag = pending.over(0.1);
        assert!(drag.direction[2] < -0.99 && drag.origin_m == [0.0, 0.5, 4.0], "relative to the domain: {drag:?}");
        assert!((drag.velocity_m_s[0] - 0.2 * height_m).abs() < 1e-12);
        assert!((DVec3::from(pending.over(1e-6).velocity_m_s).length() - MOST_M_S).abs() < 1e-9);
        input.restart();
        assert_eq!(input.pending(&dragged(0.0, 0.0), &view()), None);
    }
}
