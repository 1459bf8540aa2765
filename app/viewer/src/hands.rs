//! What hands do on the picture: turn it, drag the fluid, hold a body, place an emitter.

use glam::DVec2;

use crate::drag::DragInput;
use crate::grip::GripInput;
use crate::messages::Kind;
use crate::orbit::Orbit;
use crate::place::{Place, placed};
use crate::playback::Playback;
use crate::pointer::Pointing;
use crate::viewer::Viewer;
use crate::viewer_scene::ViewerScene;

/// What is in hand.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hands {
    drag: DragInput,
    grip: GripInput,
    /// What the next touch of the picture places.
    pub placing: Option<Place>,
    /// Whether the touch that goes on placed something: it then pushes nothing.
    placed: bool,
}

impl Hands {
    /// The simulation went on with what was dragged. While it stands nothing is moved by hand, nor later for it.
    pub fn rest(&mut self, playback: &Playback) {
        if playback.drag.is_none() || playback.paused {
            self.drag.restart();
        }
        if playback.grip.is_none() || playback.paused {
            self.grip.restart();
        }
    }

    /// Lets go of what is held: another scene has other bodies.
    pub fn let_go(&mut self) {
        self.grip.let_go();
    }

    /// From where a held body is seen to be held to where the hand is, in parts of the picture's width and height.
    pub fn tether(&self, current: &ViewerScene) -> Option<[DVec2; 2]> {
        let (solid, in_frame_m, target_m) = self.grip.tether()?;
        Some([current.seen_at(solid, in_frame_m)?, current.seen(target_m)?])
    }
}

impl Viewer {
    /// Does what the pointer did on the picture.
    pub(crate) fn reach(&mut self, pointing: &Pointing) {
        let Some(orbit) = &mut self.orbit else { return };
        self.steered |= pointing.steer(orbit);
        if !self.steered
            && let Some(current) = &self.current
        {
            self.orbit = Some(Orbit::of(&self.framed(&current.scene)));
        }
        let (Some(orbit), Some(current)) = (&self.orbit, &mut self.current) else { return };
        let camera = orbit.camera();
        if current.view().camera != camera {
            if let Err(error) = current.look_from(camera) {
                self.messages.notify(Kind::Error, error.to_string());
            }
            self.playback.redraw();
        }
        if let Some(at) = pointing.pressed {
            self.hands.placed = self.place(at);
        }
        let Some(current) = &self.current else { return };
        (self.playback.drag, self.playback.grip) = (None, None);
        if self.hands.placed {
            return;
        }
        self.playback.grip = self.hands.grip.follow(pointing, current.view(), |at| current.pick(at));
        if self.playback.grip.is_none() {
            self.playback.drag = self.hands.drag.pending(pointing, current.view());
        }
    }

    /// Places at a place of the picture what is in hand; whether something was.
    fn place(&mut self, at: DVec2) -> bool {
        let (Some(place), Some(current)) = (self.hands.placing.take(), &self.current) else { return false };
        match placed(current, place, at, self.playback.stats.as_ref().map(|stats| stats.particles)) {
            Ok(scene) => self.apply(scene),
            Err(reason) => self.messages.notify(Kind::Warning, reason),
        }
        true
    }
}
