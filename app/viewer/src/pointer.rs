//! What mouse, trackpad and fingers do on the picture.

use egui::{Event, Modifiers, PointerButton, Pos2, Rect, Response};
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
    /// Where the fluid is dragged (the middle of the way), and by how much the hand moved.
    pub drag: Option<(DVec2, DVec2)>,
    /// Where the main button (or one finger) came down on the picture.
    pub pressed: Option<DVec2>,
    /// Where it last was while it was down.
    pub main_at: Option<DVec2>,
    /// Whether it is down at the frame's end.
    pub is_held: bool,
}

/// Points of a mouse wheel that come nearer by a factor of e.
const POINTS_A_FACTOR: f32 = 400.0;

/// Drags on the picture, followed from event to event. What egui says of a drag holds at the end of a frame: one
/// that begins and ends between two frames would be none, and at two frames a second that is what a person does.
#[derive(Clone, Debug, Default)]
pub struct Strokes {
    held: Option<Held>,
    /// Where the main button came down last in the frame.
    pressed: Option<Pos2>,
}

/// A button that went down on the picture.
#[derive(Clone, Copy, Debug)]
struct Held {
    button: PointerButton,
    shift: bool,
    at: Pos2,
}

/// One way of a button that is held.
struct Stroke {
    held: Held,
    to: Pos2,
}

impl Strokes {
    /// The ways of a frame. `is_free` says of a place whether the picture is what is there.
    fn follow(&mut self, events: &[Event], is_free: impl Fn(Pos2) -> bool) -> Vec<Stroke> {
        let mut strokes = Vec::new();
        self.pressed = None;
        for event in events {
            let to = match *event {
                Event::PointerMoved(to) => to,
                Event::PointerButton { pos, button, pressed: true, modifiers: Modifiers { shift, .. } } => {
                    if self.held.is_none() && is_free(pos) {
                        self.held = Some(Held { button, shift, at: pos });
                        self.pressed = (button == PointerButton::Primary).then_some(pos).or(self.pressed);
                    }
                    continue;
                }
                Event::PointerButton { pos, .. } => pos,
                Event::PointerGone => {
                    self.held = None;
                    continue;
                }
                _ => continue,
            };
            let Some(held) = self.held else { continue };
            strokes.push(Stroke { held, to });
            let ends = matches!(event, Event::PointerButton { button, .. } if *button == held.button);
            self.held = (!ends).then_some(Held { at: to, ..held });
        }
        strokes
    }
}

impl Pointing {
    /// Reads the pointer over the picture: the main button (or one finger) drags the fluid, the second
    /// turns, the third (or the second with Shift) moves sideways, the wheel comes nearer; two fingers do
    /// the last three at once.
    pub fn on(response: &Response, strokes: &mut Strokes) -> Self {
        let rect = response.rect;
        let mut pointing = Self { zoomed: 1.0, ..Self::default() };
        if let Some(touch) = response.ctx.multi_touch() {
            *strokes = Strokes::default();
            pointing.zoomed = f64::from(touch.zoom_delta);
            pointing.turned = parts(rect, touch.translation_delta);
            return pointing;
        }
        let is_free = |at: Pos2| {
            let is_covered = response.ctx.layer_id_at(at).is_some_and(|layer| layer != response.layer_id);
            rect.contains(at) && !is_covered
        };
        let events = response.ctx.input(|input| input.events.clone());
        pointing.take_frame(rect, strokes, &events, is_free);
        if response.hovered() {
            let (wheel, pinch) = response.ctx.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            pointing.zoomed = f64::from((wheel / POINTS_A_FACTOR).exp() * pinch);
        }
        pointing
    }

    fn take_frame(&mut self, rect: Rect, strokes: &mut Strokes, events: &[Event], is_free: impl Fn(Pos2) -> bool) {
        let ways = strokes.follow(events, is_free);
        self.take(rect, &ways);
        let held = strokes.held.filter(|held| held.button == PointerButton::Primary);
        let last = ways.iter().rev().find(|stroke| stroke.held.button == PointerButton::Primary);
        self.is_held = held.is_some();
        self.pressed = strokes.pressed.map(|at| place(rect, at));
        self.main_at = held.map(|held| held.at).or(last.map(|stroke| stroke.to)).map(|at| place(rect, at));
    }

    fn take(&mut self, rect: Rect, strokes: &[Stroke]) {
        let is_drag = |stroke: &&Stroke| stroke.held.button == PointerButton::Primary;
        for Stroke { held, to } in strokes {
            let moved = parts(rect, *to - held.at);
            match held.button {
                PointerButton::Secondary if !held.shift => self.turned += moved,
                PointerButton::Secondary | PointerButton::Middle => self.panned += moved,
                _ => {}
            }
        }
        let mut drags = strokes.iter().filter(is_drag);
        if let Some(first) = drags.next() {
            let last = drags.next_back().unwrap_or(first);
            let middle = place(rect, first.held.at + (last.to - first.held.at) * 0.5);
            let moved = strokes.iter().filter(is_drag).map(|stroke| parts(rect, stroke.to - stroke.held.at)).sum();
            self.drag = Some((middle, moved));
        }
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

/// In parts of a rectangle's width and height.
fn place(rect: Rect, at: Pos2) -> DVec2 {
    let share = (at - rect.min) / rect.size();
    DVec2::new(f64::from(share.x), f64::from(share.y))
}

/// In parts of a rectangle's height.
fn parts(rect: Rect, moved: egui::Vec2) -> DVec2 {
    let height = rect.height().max(1.0);
    DVec2::new(f64::from(moved.x / height), f64::from(moved.y / height))
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    const RECT: Rect = Rect { min: pos2(100.0, 50.0), max: pos2(500.0, 250.0) };

    fn button(button: PointerButton, at: Pos2, pressed: bool) -> Event {
        Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE }
    }

    fn pointed(strokes: &mut Strokes, events: &[Event]) -> Pointing {
        let mut pointing = Pointing::default();
        pointing.take_frame(RECT, strokes, events, |at| RECT.contains(at));
        pointing
    }

    #[test]
    fn a_drag_between_two_frames_is_a_drag() {
        let mut strokes = Strokes::default();
        let [from, to] = [pos2(200.0, 150.0), pos2(300.0, 130.0)];
        let quick = [
            button(PointerButton::Primary, from, true),
            Event::PointerMoved(to),
            button(PointerButton::Primary, to, false),
        ];
        let pointing = pointed(&mut strokes, &quick);
        assert!(!pointing.is_held && pointing.pressed.is_some_and(|at| at.abs_diff_eq(DVec2::new(0.25, 0.5), 1e-6)));
        assert!(pointing.main_at.is_some_and(|at| at.abs_diff_eq(DVec2::new(0.5, 0.4), 1e-6)), "{pointing:?}");
        let (at, moved) = pointing.drag.unwrap();
        assert!(at.abs_diff_eq(DVec2::new(0.375, 0.45), 1e-6), "the middle of the way: {at}");
        assert!(moved.abs_diff_eq(DVec2::new(0.5, -0.1), 1e-6), "{moved}");
        assert!(strokes.held.is_none());
        assert_eq!(pointed(&mut strokes, &[Event::PointerMoved(from)]), Pointing::default());
    }

    #[test]
    fn a_slow_drag_goes_on_from_frame_to_frame() {
        let mut strokes = Strokes::default();
        let at = |x: f32| pos2(x, 150.0);
        pointed(&mut strokes, &[button(PointerButton::Secondary, at(200.0), true)]);
        // Beyond the picture, too, once it began there; another button changes nothing.
        let events = [Event::PointerMoved(at(250.0)), button(PointerButton::Primary, at(250.0), true)];
        assert_eq!(pointed(&mut strokes, &events).turned, DVec2::new(0.25, 0.0));
        assert_eq!(pointed(&mut strokes, &[Event::PointerMoved(at(650.0))]).turned, DVec2::new(2.0, 0.0));
        let end = pointed(&mut strokes, &[button(PointerButton::Secondary, at(650.0), false)]);
        assert_eq!((end.turned, end.drag), (DVec2::ZERO, None));
        assert!(strokes.held.is_none());
    }

    #[test]
    fn the_main_button_is_held_where_it_is_though_it_is_still() {
        let mut strokes = Strokes::default();
        let at = pos2(300.0, 150.0);
        let down = pointed(&mut strokes, &[button(PointerButton::Primary, at, true)]);
        let middle = Some(DVec2::splat(0.5));
        assert_eq!((down.pressed, down.main_at, down.is_held, down.drag), (middle, middle, true, None));
        let still = pointed(&mut strokes, &[]);
        assert_eq!((still.pressed, still.main_at, still.is_held), (None, middle, true));
        let up = pointed(&mut strokes, &[button(PointerButton::Primary, at, false)]);
        assert_eq!((up.main_at, up.is_held), (middle, false));
        // Another button is not the main one.
        let other = pointed(&mut strokes, &[button(PointerButton::Secondary, at, true)]);
        assert_eq!((other.pressed, other.main_at, other.is_held), (None, None, false));
    }

    #[test]
    fn what_begins_beside_the_picture_or_loses_the_pointer_is_none() {
        let mut strokes = Strokes::default();
        let [beside, on] = [pos2(50.0, 150.0), pos2(200.0, 150.0)];
        let events = [button(PointerButton::Primary, beside, true), Event::PointerMoved(on)];
        assert_eq!(pointed(&mut strokes, &events).drag, None);
        pointed(
            &mut strokes,
            &[button(PointerButton::Primary, beside, false), button(PointerButton::Primary, on, true)],
        );
        assert_eq!(pointed(&mut strokes, &[Event::PointerGone, Event::PointerMoved(beside)]).drag, None);
    }
}
