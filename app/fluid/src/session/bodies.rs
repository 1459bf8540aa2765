//! How bodies move, to the host and back.

use brooklet_gpu::GpuError;
use brooklet_kernels::REACTION_WORDS;

use super::Session;
use crate::body_motion::BodyMotion;
use crate::boundary::bodies::BodyBuffers;
use crate::scene::poses_before;

impl Session {
    /// Waits, and copies to the host how the bodies move.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn read_bodies(&mut self) -> Result<BodyMotion, GpuError> {
        let Some(BodyBuffers { count, states, reactions, .. }) = &self.recorded.bodies else {
            return Ok(BodyMotion::default());
        };
        let mut motion = BodyMotion { states: self.engine.read(states)?, reactions: self.engine.read(reactions)? };
        motion.states.truncate(*count as usize);
        motion.reactions.truncate((count * REACTION_WORDS) as usize);
        Ok(motion)
    }

    /// Lets the bodies go on as `motion` says, before the next frame, and puts all other solids where they begin; nothing if
    /// it is of more or fewer bodies.
    pub fn write_bodies(&mut self, motion: &BodyMotion) {
        let has = self.recorded.bodies.as_ref().map_or(0, |bodies| bodies.count as usize);
        if motion.states.len() != has {
            return;
        }
        if let Some(BodyBuffers { states, reactions, .. }) = &self.recorded.bodies {
            self.engine.write(states, &motion.states);
            self.engine.write(reactions, &motion.reactions);
        }
        if let Some(poses) = &self.recorded.solid_poses {
            self.engine.write(poses, &poses_before(&self.scene, &motion.states));
        }
    }
}
