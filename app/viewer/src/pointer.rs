//! What mouse, trackpad and fingers do on the picture.

use egui::{PointerButton, Response, Vec2};
use glam::DVec2;

use crate::orbit::Orbit;

/// What the pointer did on the picture in a frame. Lengths are parts of the picture's height, places
/// parts of its width and height.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pointing {
    /// Turned by.
    pub turned: DVec2,
    /// Moved sideways by.
    pub panned: DVec2,
    /// Nearer by a factor; 1: not.
    pub zoomed: f64,
    /// Where the fluid is pushed, and by how much the hand moved.
    pub push: Option<(DVec2, DVec2)>,
}

/// Points of a mouse wheel that come nearer by a factor of e.
const POINTS_A_FACTOR: f32 = 400.0;

impl Pointing {
    /// Reads the pointer over the picture: the main button (or one finger) pushes the fluid, the second
    /// turns, the third (or the second with Shift) moves sideways, the wheel comes nearer; two fingers do
    /// the last three at once.
    pub fn on(response: &Response) -> Self {
        let rect = response.rect;
        let height = rect.height().max(1.0);
        let parts = |moved: Vec2| DVec2::new(f64::from(moved.x / height), f64::from(moved.y / height));
        let mut pointing = Self { zoomed: 1.0, ..Self::default() };
        let moved = parts(response.drag_delta());
        let shift = response.ctx.input(|input| input.modifiers.shift);
        if let Some(touch) = response.ctx.multi_touch() {
            pointing.zoomed = f64::from(touch.zoom_delta);
            pointing.turned = parts(touch.translation_delta);
            return pointing;
        }
        if response.dragged_by(PointerButton::Middle) || (shift && response.dragged_by(PointerButton::Secondary)) {
            pointing.panned = moved;
        } else if response.dragged_by(PointerButton::Secondary) {
            pointing.turned = moved;
        } else if response.dragged_by(PointerButton::Primary)
            && let Some(at) = response.interact_pointer_pos()
        {
            let place = (at - rect.min) / rect.size();
            pointing.push = Some((DVec2::new(f64::from(place.x), f64::from(place.y)), moved));
        }
        if response.hovered() {
            let (wheel, pinch) = response.ctx.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            pointing.zoomed = f64::from((wheel / POINTS_A_FACTOR).exp() * pinch);
        }
        pointing
    }

    /// Moves the camera; whether it moved.
    pub fn steer(&self, orbit: &mut Orbit) -> bool {
        let before = *orbit;
        if self.turned != DVec2::ZERO {
            orbit.turn(self.turned);
        }
        if self.panned != DVec2::ZERO {
            orbit.pan(self.panned);
        }
        if self.zoomed != 1.0 {
            orbit.zoom(self.zoomed);
        }
        before != *orbit
    }
}
