//! What hands do on the picture: turn it, drag the fluid, hold a body, place an emitter.

use glam::DVec2;

use crate::messages::Kind;
use crate::orbit::Orbit;
use crate::place::placed;
use crate::pointer::Pointing;
use crate::viewer::Viewer;

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
