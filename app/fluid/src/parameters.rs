//! The settings that a running simulation takes without a new plan.

use brooklet_gpu::Engine;
use brooklet_kernels::{Buffer, GridParams, PbfParams, SmoothingKernelParams, StepParams};

use crate::scene::{Applied, Change, Scene};
use crate::solver::pbf;
use crate::step_params::step_params;
use crate::{grid, smoothing_kernel};

/// The uniform buffers of a recorded scene.
pub struct Parameters {
    pub(crate) scene: Scene,
    pub(crate) particle_count: u32,
    pub(crate) grid: Buffer<GridParams>,
    pub(crate) step: Buffer<StepParams>,
    pub(crate) kernel: Buffer<SmoothingKernelParams>,
    pub(crate) pbf: Buffer<PbfParams>,
}

impl Parameters {
    /// Writes what `scene` says into the uniforms of an engine that runs the scene these were recorded of;
    /// the next frame has it.
    ///
    /// # Errors
    /// If a field changed that uniforms alone do not change; nothing is written then.
    pub fn write(&self, engine: &mut Engine, scene: &Scene) -> Result<(), Change> {
        let change = self.scene.change_to(scene);
        if change.applied != Applied::Live {
            return Err(change);
        }
        engine.write(&self.grid, &[grid::params(scene, self.particle_count)]);
        engine.write(&self.step, &[step_params(scene, self.particle_count)]);
        engine.write(&self.kernel, &[smoothing_kernel::params(scene)]);
        engine.write(&self.pbf, &[pbf::params(scene)]);
        Ok(())
    }
}
