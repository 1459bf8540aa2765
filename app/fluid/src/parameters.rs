//! The settings that a running simulation takes without a new plan.

use brooklet_gpu::Engine;
use brooklet_kernels::{Buffer, ForceParams, GridParams, NoneParams, PbfParams, SmoothingKernelParams, StepParams};

use crate::scene::{Applied, Change, Scene};
use crate::solver::{Solver, none, pbf};
use crate::step_context::StepContext;
use crate::step_params::step_params;
use crate::{forces, grid, smoothing_kernel};

/// The uniform buffers of a recorded scene.
pub struct Parameters {
    scene: Scene,
    particle_count: u32,
    step: Buffer<StepParams>,
    solver: SolverParams,
}

enum SolverParams {
    Pbf {
        grid: Buffer<GridParams>,
        kernel: Buffer<SmoothingKernelParams>,
        pbf: Buffer<PbfParams>,
        forces: Buffer<ForceParams>,
    },
    None(Buffer<NoneParams>),
}

impl Parameters {
    pub(crate) fn of(scene: &Scene, particle_count: u32, context: &StepContext, solver: &Solver) -> Self {
        let solver = match solver {
            Solver::Pbf(pbf) => SolverParams::Pbf {
                grid: pbf.search.grid.params.alias(),
                kernel: pbf.search.smoothing_kernel.alias(),
                pbf: pbf.params.alias(),
                forces: pbf.forces.params.alias(),
            },
            Solver::None(none) => SolverParams::None(none.params.alias()),
        };
        Self { scene: scene.clone(), particle_count, step: context.step.alias(), solver }
    }

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
        engine.write(&self.step, &[step_params(scene, self.particle_count)]);
        match &self.solver {
            SolverParams::Pbf { grid, kernel, pbf, forces } => {
                engine.write(grid, &[grid::params(scene, self.particle_count)]);
                engine.write(kernel, &[smoothing_kernel::params(scene)]);
                engine.write(pbf, &[pbf::params(scene)]);
                engine.write(forces, &[forces::params(scene)]);
            }
            SolverParams::None(none) => engine.write(none, &[none::params(scene)]),
        }
        Ok(())
    }
}
