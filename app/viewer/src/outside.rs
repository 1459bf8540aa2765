//! What the program round the window knows of the world outside: heat, and which way is down.

use crate::viewer::Viewer;

impl Viewer {
    /// Takes the budget as `share` of itself from now on, above 0 to 1: a device that is about to be throttled.
    pub fn be_strict(&mut self, share: f64) {
        self.governor.be_strict(share);
    }

    /// Gravity in place of the scene's own, m/s², from the next frame on and for every scene; none: its own, from the next
    /// scene on.
    pub fn set_gravity(&mut self, gravity_m_s2: Option<[f64; 3]>) {
        self.gravity_m_s2 = gravity_m_s2;
    }

    /// Writes what is recorded of the capture, and goes on with it.
    pub fn flush_capture(&mut self) {
        self.playback.flush_capture(&mut self.messages);
    }

    /// Paints the picture anew, whatever moves: the window had another, or none.
    pub fn repaint(&mut self) {
        self.playback.redraw();
    }
}
