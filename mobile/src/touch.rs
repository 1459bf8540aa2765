//! Fingers, as egui wants them: each a touch, and the first one a mouse as well.

use std::collections::BTreeMap;

use egui::{Event, Modifiers, PointerButton, Pos2, TouchDeviceId, TouchId, pos2};

/// What a finger did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TouchPhase {
    /// It came down.
    Start,
    /// It moved.
    Move,
    /// It was lifted.
    End,
    /// The system took it away.
    Cancel,
}

/// A finger on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchEvent {
    /// Which one, for as long as it is down.
    pub id: u64,
    /// What it did.
    pub phase: TouchPhase,
    /// Where, from the left.
    pub x_px: f32,
    /// Where, from the top.
    pub y_px: f32,
}

/// A reading of the accelerometer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acceleration {
    /// In the device's axes: x to the right, y up, z out of the screen, of the device as it is held by nature. At rest it is
    /// opposite to gravity, as Android has it.
    pub m_s2: [f32; 3],
    /// How far the display is turned from that, counterclockwise: 0, 90, 180 or 270.
    pub rotation_degrees: u32,
}

/// Fingers that are down.
#[derive(Debug, Default)]
pub struct Touches {
    down: BTreeMap<u64, Pos2>,
    /// The finger that is the mouse, if one is.
    mouse: Option<u64>,
    /// What is not handed on yet.
    events: Vec<Event>,
}

impl Touches {
    /// Takes what a finger did. One that comes down twice, or moves or goes without having come, is a finger all the same:
    /// systems lose events.
    pub fn take(&mut self, event: TouchEvent, pixels_per_point: f32) {
        let at = pos2(event.x_px, event.y_px) / pixels_per_point;
        if !(at.x.is_finite() && at.y.is_finite()) {
            return;
        }
        let is_down = self.down.contains_key(&event.id);
        match event.phase {
            TouchPhase::Start if is_down => self.moved(event.id, at),
            TouchPhase::Start => self.came(event.id, at),
            TouchPhase::Move if is_down => self.moved(event.id, at),
            TouchPhase::End if is_down => self.went(event.id, at, true),
            TouchPhase::Cancel if is_down => self.went(event.id, at, false),
            TouchPhase::Move | TouchPhase::End | TouchPhase::Cancel => {}
        }
    }

    /// Takes all fingers away: the app is no longer in front.
    pub fn cancel(&mut self) {
        for (id, at) in std::mem::take(&mut self.down) {
            self.down.insert(id, at);
            self.went(id, at, false);
        }
    }

    /// What happened since the last call.
    pub fn events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.events)
    }

    /// Whether something happened since then.
    pub fn is_new(&self) -> bool {
        !self.events.is_empty()
    }

    fn came(&mut self, id: u64, at: Pos2) {
        self.touch(id, egui::TouchPhase::Start, at);
        if self.down.is_empty() {
            self.mouse = Some(id);
            self.events.extend([Event::PointerMoved(at), button(at, true)]);
        }
        self.down.insert(id, at);
    }

    fn moved(&mut self, id: u64, at: Pos2) {
        self.touch(id, egui::TouchPhase::Move, at);
        if self.mouse == Some(id) {
            self.events.push(Event::PointerMoved(at));
        }
        self.down.insert(id, at);
    }

    fn went(&mut self, id: u64, at: Pos2, lifted: bool) {
        let phase = if lifted { egui::TouchPhase::End } else { egui::TouchPhase::Cancel };
        self.touch(id, phase, at);
        if self.mouse == Some(id) {
            self.mouse = None;
            if lifted {
                self.events.push(button(at, false));
            }
            // Nothing hovers where no finger is.
            self.events.push(Event::PointerGone);
        }
        self.down.remove(&id);
    }

    fn touch(&mut self, id: u64, phase: egui::TouchPhase, pos: Pos2) {
        self.events.push(Event::Touch { device_id: TouchDeviceId(0), id: TouchId(id), phase, pos, force: None });
    }
}

fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn touch(id: u64, phase: TouchPhase, x_px: f32) -> TouchEvent {
        TouchEvent { id, phase, x_px, y_px: 20.0 }
    }

    fn pressed(events: &[Event]) -> Vec<bool> {
        let press = |event: &Event| match event {
            Event::PointerButton { pressed, .. } => Some(*pressed),
            _ => None,
        };
        events.iter().filter_map(press).collect()
    }

    #[test]
    fn the_first_finger_is_a_mouse_and_others_are_not() {
        let mut touches = Touches::default();
        for event in [
            touch(7, TouchPhase::Start, 10.0),
            touch(8, TouchPhase::Start, 50.0),
            touch(8, TouchPhase::Move, 60.0),
            touch(7, TouchPhase::Move, 20.0),
            touch(7, TouchPhase::End, 20.0),
            touch(8, TouchPhase::End, 60.0),
        ] {
            touches.take(event, 2.0);
        }
        let events = touches.events();
        assert_eq!(pressed(&events), [true, false]);
        let moved = |at: Pos2| events.contains(&Event::PointerMoved(at));
        assert!(moved(pos2(10.0, 10.0)) && !moved(pos2(30.0, 10.0)), "points, of the first one: {events:?}");
        let fingers = events.iter().filter(|event| matches!(event, Event::Touch { .. })).count();
        assert_eq!(fingers, 6);
        assert!(touches.events().is_empty());
    }

    #[test]
    fn what_is_taken_away_presses_nothing() {
        let mut touches = Touches::default();
        touches.take(touch(1, TouchPhase::Start, 10.0), 1.0);
        touches.take(touch(2, TouchPhase::Start, 10.0), 1.0);
        touches.cancel();
        let events = touches.events();
        assert_eq!(pressed(&events), [true], "no release: no click");
        assert!(events.contains(&Event::PointerGone));
        touches.take(touch(1, TouchPhase::Move, 90.0), 1.0);
        assert!(touches.events().is_empty(), "it is not down any more");
    }

    #[test]
    fn lost_and_senseless_events_do_no_harm() {
        let mut touches = Touches::default();
        touches.take(touch(1, TouchPhase::End, 10.0), 1.0);
        touches.take(touch(1, TouchPhase::Start, f32::NAN), 1.0);
        assert!(touches.events().is_empty());
        touches.take(touch(1, TouchPhase::Start, 1.0), 1.0);
        touches.take(touch(1, TouchPhase::Start, 2.0), 1.0);
        touches.take(touch(1, TouchPhase::End, 2.0), 1.0);
        assert_eq!(pressed(&touches.events()), [true, false]);
    }
}
