//! How a scene is timed, and its plan.

use brooklet_fluid::Scene;
use brooklet_gpu::Gpu;
use brooklet_render::{ScenePlan, ScenePlanError};

use crate::BenchError;

/// How long a scene is timed.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Steps before those that are timed.
    pub warm_up: u64,
    /// Steps that are timed.
    pub steps: u64,
    /// Pictures that are timed after them; 0 times none.
    pub pictures: u32,
}

/// A picture's fault is the scene's; a mistake in a recording is the program's.
pub(crate) fn plan(gpu: &Gpu, scene: &Scene) -> Result<ScenePlan, BenchError> {
    ScenePlan::new(scene, gpu.tier()).map_err(|error| match error {
        ScenePlanError::Render { .. } => BenchError::input(error),
        ScenePlanError::Plan(_) => BenchError::stopped(error),
    })
}
