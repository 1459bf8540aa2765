//! What is in hand on the picture: the fluid that is dragged, a body that is held, an emitter to place.

use glam::DVec2;

use crate::drag::DragInput;
use crate::grip::GripInput;
use crate::place::Place;
use crate::playback::Playback;
use crate::viewer_scene::ViewerScene;

/// What is in hand.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hands {
    pub(crate) drag: DragInput,
    pub(crate) grip: GripInput,
    /// What the next touch of the picture places.
    pub placing: Option<Place>,
    /// Whether the touch that goes on placed something: it then pushes nothing.
    pub(crate) placed: bool,
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
