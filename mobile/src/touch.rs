//! Fingers, as egui wants them: each a touch, and one of them a mouse as well.
//!
//! A finger belongs to what it came down on, a panel or the picture, until it is lifted. Fingers on the picture are touches of
//! one device, each on a panel of a device of its own: so two turn the scene only if both are on the picture. The mouse is
//! pressed by a finger on a panel, or by one that is alone on the picture; when a second one comes there, it is released, and
//! whichever stays behind presses nothing before it is lifted.

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

/// What a finger came down on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A panel, or anything else that lies over the picture.
    Panel,
    /// The picture.
    Picture,
}

/// A finger that is down.
#[derive(Clone, Copy, Debug)]
struct Finger {
    at: Pos2,
    place: Place,
}

/// The finger that is the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mouse {
    id: u64,
    place: Place,
    /// Whether the button is down. In a pinch it is not, and the mouse only says where it is.
    pressed: bool,
}

/// Fingers that are down.
#[derive(Debug, Default)]
pub struct Touches {
    down: BTreeMap<u64, Finger>,
    mouse: Option<Mouse>,
    /// What is not handed on yet.
    events: Vec<Event>,
}

/// Beyond every screen: a button that is let go there was not clicked.
const NOWHERE: Pos2 = pos2(-1.0e5, -1.0e5);

impl Touches {
    /// Takes what a finger did; `place` says what is at a point, and is asked when one comes down. One that comes down twice, or
    /// moves or goes without having come, is a finger all the same: systems lose events.
    pub fn take(&mut self, event: TouchEvent, pixels_per_point: f32, place: impl FnOnce(Pos2) -> Place) {
        let at = pos2(event.x_px, event.y_px) / pixels_per_point;
        if !(at.x.is_finite() && at.y.is_finite()) {
            return;
        }
        match (event.phase, self.down.get(&event.id).copied()) {
            (TouchPhase::Start, None) => self.came(event.id, Finger { at, place: place(at) }),
            (TouchPhase::Start | TouchPhase::Move, Some(finger)) => self.moved(event.id, Finger { at, ..finger }),
            (TouchPhase::End, Some(finger)) => self.went(event.id, Finger { at, ..finger }, true),
            (TouchPhase::Cancel, Some(finger)) => self.went(event.id, Finger { at, ..finger }, false),
            (TouchPhase::Move | TouchPhase::End | TouchPhase::Cancel, None) => {}
        }
    }

    /// Takes all fingers away: the app is no longer in front.
    pub fn cancel(&mut self) {
        for (id, finger) in self.down.clone() {
            self.went(id, finger, false);
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

    fn came(&mut self, id: u64, finger: Finger) {
        self.touch(id, egui::TouchPhase::Start, finger);
        let is_alone = !self.down.values().any(|other| other.place == finger.place);
        self.down.insert(id, finger);
        let presses = match finger.place {
            // A button is for whoever touches it, whatever is done beside it.
            Place::Panel => self.mouse.is_none_or(|mouse| mouse.place == Place::Picture),
            Place::Picture => is_alone && self.mouse.is_none(),
        };
        if (presses || !is_alone)
            && let Some(mouse) = self.mouse.as_mut().filter(|mouse| mouse.place == Place::Picture && mouse.pressed)
        {
            mouse.pressed = false;
            let at = self.down.get(&mouse.id).map_or(finger.at, |finger| finger.at);
            self.events.push(button(at, false));
        }
        if presses || self.mouse.is_none() {
            self.mouse = Some(Mouse { id, place: finger.place, pressed: presses });
            self.events.push(Event::PointerMoved(finger.at));
        }
        if presses {
            self.events.push(button(finger.at, true));
        }
    }

    fn moved(&mut self, id: u64, finger: Finger) {
        self.touch(id, egui::TouchPhase::Move, finger);
        if self.mouse.is_some_and(|mouse| mouse.id == id) {
            self.events.push(Event::PointerMoved(finger.at));
        }
        self.down.insert(id, finger);
    }

    fn went(&mut self, id: u64, finger: Finger, lifted: bool) {
        let phase = if lifted { egui::TouchPhase::End } else { egui::TouchPhase::Cancel };
        self.touch(id, phase, finger);
        self.down.remove(&id);
        let Some(mouse) = self.mouse.take_if(|mouse| mouse.id == id) else { return };
        match (mouse.pressed, lifted) {
            (false, _) => {}
            (true, true) => self.events.push(button(finger.at, false)),
            // It is let go where nothing is, without a way to there: otherwise the next finger would click what this one
            // was on.
            (true, false) => {
                self.events.extend([Event::PointerGone, Event::PointerMoved(NOWHERE), button(NOWHERE, false)]);
            }
        }
        // Nothing hovers where no finger is.
        self.events.push(Event::PointerGone);
    }

    fn touch(&mut self, id: u64, phase: egui::TouchPhase, Finger { at, place }: Finger) {
        let device_id = match place {
            Place::Picture => TouchDeviceId(0),
            Place::Panel => TouchDeviceId(id.wrapping_add(1).max(1)),
        };
        self.events.push(Event::Touch { device_id, id: TouchId(id), phase, pos: at, force: None });
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

    /// Panels lie left of 100 pixels.
    fn take(touches: &mut Touches, events: &[TouchEvent]) -> Vec<Event> {
        for event in events {
            touches.take(*event, 1.0, |at| if at.x < 100.0 { Place::Panel } else { Place::Picture });
        }
        touches.events()
    }

    fn pressed(events: &[Event]) -> Vec<(bool, f32)> {
        let press = |event: &Event| match event {
            Event::PointerButton { pressed, pos, .. } => Some((*pressed, pos.x)),
            _ => None,
        };
        events.iter().filter_map(press).collect()
    }

    /// Fingers that are down on one device at the end, most of them.
    fn most_together(events: &[Event]) -> usize {
        let mut devices: BTreeMap<u64, Vec<u64>> = BTreeMap::new();
        let mut most = 0;
        for event in events {
            let Event::Touch { device_id, id, phase, .. } = event else { continue };
            let fingers = devices.entry(device_id.0).or_default();
            match phase {
                egui::TouchPhase::Start => fingers.push(id.0),
                egui::TouchPhase::Move => assert!(fingers.contains(&id.0), "{id:?} moves on another device"),
                _ => fingers.retain(|finger| *finger != id.0),
            }
            most = most.max(fingers.len());
        }
        most
    }

    use TouchPhase::{Cancel, End, Move, Start};

    #[test]
    fn one_finger_is_a_mouse_and_two_on_the_picture_are_a_pinch() {
        let mut touches = Touches::default();
        touches.take(touch(7, Start, 400.0), 2.0, |_| Place::Picture);
        touches.take(touch(7, Move, 420.0), 2.0, |_| unreachable!("asked once"));
        let events = touches.events();
        assert_eq!(pressed(&events), [(true, 200.0)], "points");
        assert!(events.contains(&Event::PointerMoved(pos2(210.0, 10.0))), "{events:?}");
        let more = [touch(8, Start, 300.0), touch(8, Move, 310.0), touch(7, Move, 200.0)];
        let events = take(&mut touches, &more);
        assert_eq!(pressed(&events), [(false, 210.0)], "where it was: {events:?}");
        assert!(events.contains(&Event::PointerMoved(pos2(200.0, 20.0))), "egui wants to know where a pinch is");
        assert!(touches.events().is_empty());
    }

    #[test]
    fn what_is_left_over_after_a_pinch_pushes_nothing_until_it_is_lifted() {
        for (first, left) in [(1, 2), (2, 1)] {
            let mut touches = Touches::default();
            let began = take(&mut touches, &[touch(1, Start, 200.0), touch(2, Start, 300.0), touch(first, End, 250.0)]);
            assert_eq!((pressed(&began).len(), most_together(&began)), (2, 2), "{began:?}");
            let after = take(&mut touches, &[touch(left, Move, 270.0), touch(left, Move, 220.0)]);
            assert_eq!(pressed(&after), [], "{left} is left");
            // Another one makes it a pinch again.
            let again = take(&mut touches, &[touch(3, Start, 350.0), touch(3, Move, 360.0), touch(3, End, 360.0)]);
            assert_eq!(pressed(&again), []);
            assert_eq!(pressed(&take(&mut touches, &[touch(left, End, 220.0)])), []);
            let anew = take(&mut touches, &[touch(left, Start, 230.0), touch(left, End, 230.0)]);
            assert_eq!(pressed(&anew), [(true, 230.0), (false, 230.0)]);
        }
    }

    #[test]
    fn a_finger_on_a_panel_is_the_panels_wherever_it_goes() {
        let mut touches = Touches::default();
        let events = [touch(1, Start, 50.0), touch(1, Move, 300.0), touch(2, Start, 200.0), touch(2, Move, 210.0)];
        let events = take(&mut touches, &events);
        assert_eq!((pressed(&events), most_together(&events)), (vec![(true, 50.0)], 1), "{events:?}");
        // And a second one on the picture makes it a pinch of those two, whatever the panel's does.
        let pinch = take(&mut touches, &[touch(3, Start, 300.0), touch(3, Move, 310.0)]);
        let fingers = |event: &&Event| matches!(event, Event::Touch { device_id: TouchDeviceId(0), .. });
        assert_eq!((pressed(&pinch), pinch.iter().filter(fingers).count()), (vec![], 2));
        assert_eq!(pressed(&take(&mut touches, &[touch(1, End, 300.0)])), [(false, 300.0)]);
        assert_eq!(pressed(&take(&mut touches, &[touch(2, Move, 240.0), touch(3, End, 310.0)])), []);
    }

    #[test]
    fn a_button_is_pressed_while_another_finger_pushes() {
        let mut touches = Touches::default();
        let events = take(&mut touches, &[touch(1, Start, 200.0), touch(1, Move, 220.0), touch(2, Start, 50.0)]);
        assert_eq!(pressed(&events), [(true, 200.0), (false, 220.0), (true, 50.0)]);
        // A second one on a panel is none, and what pushed before pushes no more.
        let events = [touch(3, Start, 60.0), touch(1, Move, 240.0), touch(2, End, 50.0), touch(1, Move, 250.0)];
        let events = take(&mut touches, &events);
        assert_eq!(pressed(&events), [(false, 50.0)]);
        assert!(!events.contains(&Event::PointerMoved(pos2(250.0, 20.0))), "{events:?}");
    }

    #[test]
    fn what_is_taken_away_clicks_nothing() {
        let mut touches = Touches::default();
        take(&mut touches, &[touch(1, Start, 10.0), touch(2, Start, 10.0)]);
        touches.cancel();
        let events = touches.events();
        assert_eq!(pressed(&events), [(false, NOWHERE.x)], "not where the button is");
        let mouse = events.iter().rfind(|event| !matches!(event, Event::Touch { .. }));
        assert_eq!(mouse, Some(&Event::PointerGone), "nothing hovers");
        let [gone, moved] = [Event::PointerGone, Event::PointerMoved(NOWHERE)];
        let place = |wanted: &Event| events.iter().position(|event| event == wanted).unwrap();
        assert!(place(&gone) < place(&moved), "the way to there is no drag: {events:?}");
        assert!(
            take(&mut touches, &[touch(1, Move, 90.0), touch(2, Cancel, 90.0)]).is_empty(),
            "none is down any more"
        );
    }

    #[test]
    fn lost_and_senseless_events_do_no_harm() {
        let mut touches = Touches::default();
        assert!(take(&mut touches, &[touch(1, End, 10.0), touch(1, Start, f32::NAN)]).is_empty());
        let events = [touch(1, Start, 101.0), touch(1, Start, 102.0), touch(1, End, 102.0)];
        assert_eq!(pressed(&take(&mut touches, &events)), [(true, 101.0), (false, 102.0)]);
    }
}
