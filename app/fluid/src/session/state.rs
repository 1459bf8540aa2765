//! A running scene, to the host and back.

use brooklet_gpu::GpuError;

use super::Session;
use crate::diffuse::DiffuseSet;
use crate::state::State;

impl Session {
    /// Waits, and copies the running scene to the host: to save it, or to go on elsewhere ([`super::SessionPlan::start_at`]).
    ///
    /// # Errors
    /// If the device is lost.
    pub fn read_state(&mut self) -> Result<State, GpuError> {
        Ok(State {
            scene: self.scene.clone(),
            time_s: self.clock_s()?,
            steps: self.steps,
            particles: self.read_particles()?,
            bodies: self.read_bodies()?,
            diffuse: self.read_diffuse()?,
        })
    }

    /// Simulated time as the GPU has summed it: what is drawn by chance or turns with time then goes on bit for bit.
    fn clock_s(&mut self) -> Result<f64, GpuError> {
        let state = self.engine.read(&self.recorded.slots.state)?[0];
        Ok(f64::from(state.time_s) - f64::from(state.time_lost_s))
    }

    /// Waits, and copies spray, foam and bubbles to the host.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn read_diffuse(&mut self) -> Result<DiffuseSet, GpuError> {
        self.recorded.diffuse.as_ref().map_or_else(|| Ok(DiffuseSet::default()), |slots| slots.read(&mut self.engine))
    }

    /// Puts spray, foam and bubbles in place of those that there are, before the next frame; nothing if the scene has none.
    pub fn write_diffuse(&mut self, set: &DiffuseSet) {
        if let Some(slots) = &self.recorded.diffuse {
            slots.write(&mut self.engine, set);
        }
    }
}
