//! Frames handed to the GPU that have not come back yet.

use std::collections::VecDeque;
use std::time::Instant;

use crate::viewer_scene::ViewerFrame;

/// A frame under way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InFlightFrame {
    /// The engine's number of it.
    pub frame: u64,
    /// What it does.
    pub request: ViewerFrame,
    /// When it was handed over.
    pub handed: Instant,
    /// The painter's number of the frame in which it is shown.
    pub painted: Option<u64>,
}

/// Frames under way, the oldest first.
#[derive(Debug, Default)]
pub struct InFlightFrames {
    frames: VecDeque<InFlightFrame>,
}

/// More of them would only make the picture older than the hand that moves it.
pub const MAX_IN_FLIGHT: usize = 2;

impl InFlightFrames {
    /// Whether another one may begin.
    pub fn has_room(&self) -> bool {
        self.frames.len() < MAX_IN_FLIGHT
    }

    /// One begins.
    pub fn begin(&mut self, in_flight: InFlightFrame) {
        self.frames.push_back(in_flight);
    }

    /// The one that came back; those before it never will.
    pub fn end(&mut self, frame: u64) -> Option<InFlightFrame> {
        while let Some(in_flight) = self.frames.pop_front() {
            if in_flight.frame >= frame {
                return (in_flight.frame == frame).then_some(in_flight);
            }
        }
        None
    }

    /// The newest is shown in a frame of the painter's.
    pub fn painted_as(&mut self, frame: u64) {
        if let Some(newest) = self.frames.back_mut() {
            newest.painted = Some(frame);
        }
    }

    /// Whether none is under way.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// Forgets all: their engine is gone.
    pub fn clear(&mut self) {
        self.frames.clear();
    }
}
